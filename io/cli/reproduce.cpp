// wellspaced reproduce: the thesis' tables and figures, beside the published ones.
#include <algorithm>
#include <array>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/reproduce/chapter.hpp"
#include "wellspaced/io/reproduce/chapter_page.hpp"
#include "wellspaced/io/reproduce/exhibit_files.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

constexpr double kMostRuns = 10'000;
constexpr double kLargestScale = 16;

LaboratoryOptions read_options(Arguments& arguments, Session& session) {
  LaboratoryOptions options;
  options.runs = static_cast<std::size_t>(arguments.integer("--runs", 30, between(1, kMostRuns)));
  options.scale = arguments.number("--scale", 1, between(0.002, kLargestScale));
  options.data = arguments.text("--data", "");
  options.seed = session.options().seed;
  options.threads = arguments.has("--threads") ? session.options().threads
                                               : std::max(1u, std::thread::hardware_concurrency());
  options.directory = session.options().output;
  options.version = WELLSPACED_VERSION;
  options.progress = session.progress();
  options.outputs = &session.outputs();
  return options;
}

std::string names_of_exhibits() {
  std::string names;
  for (const ExhibitKind& kind : exhibit_kinds()) names.append(kind.name).append(", ");
  return concat({names, "all"});
}

std::vector<const ExhibitKind*> find_exhibits(const std::string& name) {
  std::vector<const ExhibitKind*> found;
  for (const ExhibitKind& kind : exhibit_kinds())
    if (name == "all" || name == kind.name) found.push_back(&kind);
  return found;
}

// Each exhibit's files appear as soon as it is complete, and stay if the next one is interrupted.
Status publish(const Exhibit& exhibit, Session& session) {
  const std::string& directory = session.options().output;
  if (directory.empty()) return Ok{};
  OutputSet& outputs = session.outputs();
  if (Status status = add_exhibit(outputs, directory, exhibit); !status) return status;
  return outputs.commit();
}

Result<std::vector<Exhibit>> make_exhibits(std::span<const ExhibitKind* const> kinds,
                                           Laboratory& laboratory, Session& session) {
  std::vector<Exhibit> exhibits;
  for (const ExhibitKind* kind : kinds) {
    auto exhibit = make_exhibit(*kind, laboratory);
    if (!exhibit) return exhibit.error();
    if (Status status = publish(*exhibit, session); !status) return status.error();
    exhibits.push_back(std::move(*exhibit));
  }
  return exhibits;
}

Status write_summary(std::span<const Exhibit> exhibits, Session& session) {
  JsonWriter json;
  json.begin_object().key("exhibits").begin_array();
  for (const Exhibit& exhibit : exhibits) append_exhibit_json(json, exhibit);
  json.end_array().end_object();
  return session.write_json(json);
}

ChapterPage page_of(std::span<const Exhibit> exhibits, const LaboratoryOptions& options) {
  ChapterPage page{{}, exhibits};
  page.parameters = {
      {"program", concat({"wellspaced ", options.version})},
      {"runs", concat({options.runs, " where the thesis made 30; in proportion elsewhere"})},
      {"first seed", std::to_string(options.seed)},
      {"meshes", options.data.empty() ? "stand-ins made by wellspaced generate"
                                      : "the original ones, as far as they survive"},
      {"grids", concat({1000 * options.scale, " nodes a side"})}};
  return page;
}

std::string chapter_text(std::span<const Exhibit> exhibits, const LaboratoryOptions& options) {
  return concat({agreement_text(agreement_of(exhibits)), '\n', exhibits.size(),
                 " tables and figures: ", options.directory, "/index.html\n"});
}

// The page of all exhibits, beside their files.
Status write_page(std::span<const Exhibit> exhibits, const LaboratoryOptions& options,
                  OutputSet& outputs) {
  const std::string html = chapter_html(page_of(exhibits, options));
  return outputs.add(concat({options.directory, "/index.html"}),
                     [&](TextWriter& out) { out << html; });
}

Result<int> run_reproduce(Arguments& arguments, Session& session) {
  const std::string& what = arguments.operands()[0];
  Laboratory laboratory(read_options(arguments, session));
  if (Status status = arguments.status(); !status)
    return Error{ErrorCode::kUsage, {"reproduce: ", status.error().message}};
  const auto kinds = find_exhibits(what);
  if (kinds.empty())
    return Error{ErrorCode::kUsage,
                 {"reproduce: ", in_quotes(what), " is none of ", names_of_exhibits()}};
  if (session.options().output == "-")
    return Error{ErrorCode::kUsage, "reproduce: -o names a directory, not the standard output"};
  if (what == "all" && session.options().output.empty())
    return Error{ErrorCode::kUsage, "reproduce: name a directory for all of it with -o"};
  if (!laboratory.options().directory.empty())
    session.say_what_stays(concat(
        {"what was complete stays in ", session.options().output, ", and is not run again"}));
  const auto exhibits = make_exhibits(kinds, laboratory, session);
  if (!exhibits) return exhibits.error();
  if (what == "all")
    if (Status status = write_page(*exhibits, laboratory.options(), session.outputs()); !status)
      return status.error();
  session.print(what == "all" ? chapter_text(*exhibits, laboratory.options())
                              : exhibit_text(exhibits->front()));
  if (Status status = write_summary(*exhibits, session); !status) return status.error();
  return kExitOk;
}

constexpr std::array kReproduceOptions = {
    Option{"--runs", "N",
           "runs of each experiment of which the thesis made 30 (default 30), in proportion of the "
           "others; on all cores, unless --threads says otherwise"},
    Option{"--data", "DIR",
           "the folder of the original meshes, as Triangle's files: crack_float32, airfoil1, ...; "
           "without it, meshes made by generate stand in for them"},
    Option{"--scale", "S", "grids of 1000 S nodes a side (default 1)"},
};

}  // namespace

extern const Command kReproduce;
const Command kReproduce = {
    .name = "reproduce",
    .operands = "WHAT",
    .summary =
        "make a table or figure of the thesis again, beside the published figures: table-8.1, 8.3 "
        "to 8.8, figure-1.1 to 1.5, 5.4, 8.5 to 8.9, section-6.1, 8.4, drawings, all",
    .least_operands = 1,
    .most_operands = 1,
    .options = kReproduceOptions,
    .run = run_reproduce};

}  // namespace wellspaced::cli
