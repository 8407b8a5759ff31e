// wellspaced convert: from one file format to another.
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

Status write_summary(const Geometry& geometry, Session& session) {
  JsonWriter json;
  json.begin_object().field("dimension", geometry.dimension);
  json.field("points", geometry.point_count()).field("triangles", geometry.mesh.triangles.size());
  json.field("tets", geometry.solid.tets.size()).field("segments", geometry.mesh.segments.size());
  json.field("holes", geometry.holes.size()).field("regions", geometry.regions.size()).end_object();
  return session.write_json(json);
}

Result<std::string> find_target(const Arguments& arguments, const Session& session) {
  const auto& operands = arguments.operands();
  const std::string& option = session.options().output;
  if ((operands.size() == 2) != option.empty())
    return Error{ErrorCode::kUsage, "convert: name one output, as OUT or with -o"};
  return option.empty() ? operands[1] : option;
}

Result<int> run_convert(Arguments& arguments, Session& session) {
  const auto target = find_target(arguments, session);
  if (!target) return target.error();
  const std::string& source = arguments.operands()[0];
  auto geometry = read_geometry(source, session.reading());
  if (!geometry) return geometry.error();
  const unsigned parts = parts_of(*geometry);
  if (!geometry->mesh.triangles.empty())
    if (Status status = prepare_geometry(*geometry, display_name(source), session.progress());
        !status)
      return status.error();
  for (const std::string& note : geometry->notes) session.note(note);
  const Status written =
      write_geometry(session.outputs(), *target, session.options().format, *geometry);
  if (!written) return written.error();
  const std::string lost = parts_left_out(*target, session.options().format, parts);
  if (!lost.empty())
    session.note(concat({*target, ": the format has no place for ", lost, ": left out"}));
  if (Status status = write_summary(*geometry, session); !status) return status.error();
  return kExitOk;
}

}  // namespace

extern const Command kConvert;
const Command kConvert = {.name = "convert",
                          .operands = "IN OUT",
                          .summary = "rewrite points, a domain or a mesh in another format",
                          .least_operands = 1,
                          .most_operands = 2,
                          .options = {},
                          .run = run_convert};

}  // namespace wellspaced::cli
