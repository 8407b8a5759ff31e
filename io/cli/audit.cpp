// wellspaced audit: the verdict on a mesh, whoever made it.
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wellspaced/algorithms/audit/embedding.hpp"
#include "wellspaced/algorithms/audit/hierarchy_audit.hpp"
#include "wellspaced/algorithms/audit/mesh_audit.hpp"
#include "wellspaced/algorithms/audit/point_mesh.hpp"
#include "wellspaced/algorithms/audit/polyhedral_domain.hpp"
#include "wellspaced/algorithms/audit/requirement.hpp"
#include "wellspaced/algorithms/audit/tet_audit.hpp"
#include "wellspaced/algorithms/audit/tet_embedding.hpp"
#include "wellspaced/algorithms/audit/theorems.hpp"
#include "wellspaced/algorithms/audit/well_spaced.hpp"
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/column_file.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/formats/hierarchy_input.hpp"
#include "wellspaced/io/formats/triangle_files.hpp"
#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/report/audit_report.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

constexpr std::array<Option, 9> kAuditOptions = {{
    {"--domain", "FILE", "the domain that the mesh must conform to"},
    {"--allowance", "ULPS",
     "how far rounding may put nodes off its segments, in units in the last place (2)"},
    {"--flatness", "X",
     "facets in space are in one plane to within this part of their extent (0: exactly)"},
    {"--spacing", "FILE|nn", "judge how the nodes are spaced by f, one value a line; nn: by NN"},
    {"--lfs", "FILE", "the same for a packing, by its local feature size"},
    {"--beta", "B", "the spacing constant that is claimed"},
    {"--require", "NAME|EXPR|@FILE",
     "let a check, or a bound like \"min_angle>=15\", count; @FILE: one a line",
     Option::Times::kAnyNumber},
    {"--strict", "", "let every check count"},
    {"--vtu", "FILE", "write the mesh with the offenders marked, for ParaView"},
}};

// What the options ask for.
struct Demands {
  std::optional<Pslg> domain;
  std::optional<audit::PolyhedralDomain> solid_domain;
  double allowance = 2;
  std::string spacing;  // a file, "nn", or empty
  bool is_packing = false;
  double beta = 0;
  std::vector<audit::Requirement> requirements;
  bool strict = false;
  std::string vtu;
};

Status add_requirement(std::string_view text, Demands& demands) {
  auto requirement = audit::parse_requirement(text);
  if (!requirement) return requirement.error();
  demands.requirements.push_back(std::move(*requirement));
  return Ok{};
}

// One requirement a line; # starts a comment.
Status read_requirements(const std::string& path, Demands& demands) {
  const auto text = read_input(path);
  if (!text) return text.error();
  std::string_view rest = *text;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::string_view content = line.substr(0, line.find('#'));
    if (content.find_first_not_of(" \t\r") == content.npos) continue;
    if (Status status = add_requirement(content, demands); !status) return status;
  }
  return Ok{};
}

Status read_domain(const std::string& path, double flatness, Session& session, Demands& demands) {
  auto geometry = read_geometry(path, session.reading());
  if (!geometry) return geometry.error();
  if (geometry->dimension == 2) {
    demands.domain = to_pslg(std::move(*geometry));
  } else {
    demands.solid_domain = audit::domain_of(to_pls(std::move(*geometry)), flatness);
  }
  return Ok{};
}

// A domain of another dimension than the mesh says nothing about it.
Status check_dimension(const Demands& demands, int dimension) {
  if (dimension == 2 ? !demands.solid_domain : !demands.domain) return Ok{};
  return Error{ErrorCode::kUsage,
               {"audit: --domain names a domain in ",
                dimension == 2 ? "space, but the mesh lies in the plane"
                               : "the plane, but the mesh lies in space"}};
}

Result<Demands> read_demands(Arguments& arguments, Session& session) {
  Demands demands;
  demands.strict = arguments.has("--strict");
  demands.vtu = arguments.text("--vtu", "");
  demands.is_packing = arguments.has("--lfs");
  demands.spacing = arguments.text("--lfs", arguments.text("--spacing", ""));
  demands.beta = arguments.number("--beta", 0, more_than(0));
  demands.allowance = arguments.number("--allowance", demands.allowance, at_least(0));
  const double flatness = arguments.number("--flatness", 0, between(0, 0.001));
  if (!arguments.status()) return arguments.status().error();
  for (const std::string& text : arguments.values("--require")) {
    const Status status = text.rfind('@', 0) == 0 ? read_requirements(text.substr(1), demands)
                                                  : add_requirement(text, demands);
    if (!status) return status.error();
  }
  if (const auto path = arguments.value("--domain"))
    if (Status status = read_domain(*path, flatness, session, demands); !status)
      return status.error();
  return demands;
}

// Readers turn a mesh whose elements are all the other way round, and say so.
void turn_if_needed(Geometry& geometry, const std::string& name, Session& session) {
  const bool clockwise = audit::is_clockwise(geometry.mesh);
  const bool negative = audit::is_negative(geometry.solid);
  if (clockwise)
    for (auto& t : geometry.mesh.triangles) std::swap(t[1], t[2]);
  if (negative)
    for (auto& t : geometry.solid.tets) std::swap(t[2], t[3]);
  if (clockwise)
    session.note(concat({name, ": all triangles were clockwise and have been turned"}));
  if (negative) session.note(concat({name, ": all tetrahedra were negative and have been turned"}));
}

// Makes checks required and adds those of bounds; about: the mesh, if the report is about one.
template <class... About>
Status apply(const Demands& demands, audit::Report& report, const About&... about) {
  if (demands.strict) audit::require_all(report);
  for (const audit::Requirement& requirement : demands.requirements)
    if (Status status = audit::require(requirement, about..., report); !status) return status;
  return Ok{};
}

template <class Mesh>
Status write_picture(const Demands& demands, const Mesh& mesh, const audit::Report& report,
                     Session& session) {
  if (demands.vtu.empty()) return Ok{};
  VtkGrid grid = vtk_grid(mesh);
  mark_offenders(report, grid);
  return session.outputs().add(demands.vtu, [&](TextWriter& out) { write_vtu(out, grid); });
}

// In Triangle's formats the .poly beside a mesh describes its whole boundary.
bool is_triangle_set(const std::string& path) { return triangle_set_name(path) != path; }

// A file whose numbers can be read, but name nodes that do not exist or are not finite, has failed
// the audit before it began.
audit::Report report_on(const Error& invalid_input, Session& session) {
  session.note(invalid_input.message);
  audit::Report report;
  report.add_required_check("valid_input", audit::Item::kNone).violate({});
  return report;
}

audit::Report audit_triangles(const std::string& path, const Geometry& geometry,
                              const Demands& demands, Session& session) {
  audit::MeshAuditOptions options;
  options.progress = session.progress();
  options.allowance = demands.allowance;
  if (demands.domain) options.domain = &*demands.domain;
  if (!demands.domain) options.holes = geometry.holes;
  if (is_triangle_set(path)) options.segments = audit::SegmentMeaning::kWholeBoundary;
  return audit::audit_mesh(geometry.mesh, options);
}

audit::Report audit_tets(const TetMesh& mesh, const Demands& demands, Session& session) {
  audit::TetAuditOptions options;
  options.progress = session.progress();
  if (demands.solid_domain) options.domain = &*demands.solid_domain;
  options.allowance = demands.allowance;
  return audit::audit_tet_mesh(mesh, options);
}

// Judges the spacing of the nodes, if that is asked for.
template <class Mesh>
Status add_spacing(const Demands& demands, const Mesh& mesh, audit::Report& report,
                   Session& session) {
  if (demands.spacing.empty() || report.check("no_overlap") == nullptr) return Ok{};
  audit::SpacingAuditOptions options;
  options.beta = demands.beta;
  options.progress = session.progress();
  std::vector<double> values;
  audit::SpacingKind kind = audit::SpacingKind::kNearestNeighbour;
  if (demands.spacing != "nn") {
    auto column = read_column(demands.spacing, mesh.points.size(), session.progress());
    if (!column) return column.error();
    values = std::move(*column);
    options.spacing = values;
    kind = demands.is_packing ? audit::SpacingKind::kLocalFeatureSize : audit::SpacingKind::kGiven;
  }
  audit::audit_spacing(mesh, options, report);
  if (!report.complete) return cancelled();
  audit::compare_with_theorems(mesh, kind, report);
  return Ok{};
}

// Completes the report on a mesh.
template <class Mesh>
Result<audit::Report> finish(audit::Report report, const Mesh& mesh, const Demands& demands,
                             Session& session) {
  if (!report.complete) return cancelled();
  if (Status status = add_spacing(demands, mesh, report, session); !status) return status.error();
  if (Status status = apply(demands, report, mesh); !status) return status.error();
  if (Status status = write_picture(demands, mesh, report, session); !status) return status.error();
  return report;
}

// A point set can be audited for its spacing alone: it gets a mesh.
Status mesh_points(const std::string& path, const Demands& demands, Session& session,
                   Geometry& geometry) {
  if (demands.spacing.empty())
    return Error{ErrorCode::kUnreadable, {display_name(path), ": holds no mesh to audit"}};
  if (geometry.dimension == 3) {
    auto mesh = audit::mesh_of_points(geometry.solid.points, session.progress());
    if (!mesh) return mesh.error();
    geometry.solid = std::move(*mesh);
    return Ok{};
  }
  auto mesh = audit::mesh_of_points(
      geometry.mesh.points, demands.domain ? &*demands.domain : nullptr, session.progress());
  if (!mesh) return mesh.error();
  geometry.mesh = std::move(*mesh);
  return Ok{};
}

// A packed mesh brings its spacing: it is judged by that unless another one is named.
Demands with_spacing_beside(const std::string& path, Demands demands) {
  if (!demands.spacing.empty()) return demands;
  const std::string beside = spacing_beside(path);
  const auto mark = read_packing_mark(beside);
  if (!mark) return demands;
  demands.spacing = beside;
  demands.is_packing = mark->is_by_lfs;
  if (demands.beta == 0) demands.beta = mark->beta;
  return demands;
}

Result<audit::Report> audit_file(const std::string& path, const Demands& given, Session& session) {
  const Demands demands = with_spacing_beside(path, given);
  auto geometry = read_geometry(path, session.reading());
  if (!geometry && geometry.error().code == ErrorCode::kInvalidGeometry)
    return report_on(geometry.error(), session);
  if (!geometry) return geometry.error();
  for (const std::string& note : geometry->notes) session.note(note);
  if (!geometry->has_cells())
    if (Status status = mesh_points(path, demands, session, *geometry); !status)
      return status.error();
  if (Status status = check_dimension(demands, geometry->dimension); !status) return status.error();
  turn_if_needed(*geometry, display_name(path), session);
  if (geometry->dimension == 2)
    return finish(audit_triangles(path, *geometry, demands, session), geometry->mesh, demands,
                  session);
  return finish(audit_tets(geometry->solid, demands, session), geometry->solid, demands, session);
}

bool is_directory(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

// Only levels selected by a function are spaced by it.
audit::HierarchyAuditOptions options_for(const HierarchyInput& input, const Demands& demands) {
  audit::HierarchyAuditOptions options;
  if (input.method != "mis") options.beta = input.beta;
  if (input.method == "function" && input.metric == "graph") options.factor = input.factor;
  if (input.scheme == "from-finest" || input.scheme == "coarse-to-fine")
    options.selected_from = audit::SelectedFrom::kFinest;
  if (!input.node_nested) options.nesting = audit::Nesting::kNotPromised;
  options.fixed = input.fixed;
  options.well_spacing = audit::WellSpacing::kMeasured;
  if (demands.domain) options.domain = &*demands.domain;
  return options;
}

Result<audit::Report> audit_directory(const std::string& path, const Demands& demands,
                                      Session& session) {
  if (!demands.vtu.empty())
    return Error{ErrorCode::kUsage, "audit: --vtu takes a mesh; name a level of the hierarchy"};
  const auto input = read_hierarchy(path, session.progress());
  if (!input && input.error().code == ErrorCode::kInvalidGeometry)
    return report_on(input.error(), session);
  if (!input) return input.error();
  for (const std::string& note : input->notes) session.note(note);
  audit::HierarchyAuditOptions options = options_for(*input, demands);
  options.progress = session.progress();
  audit::Report report = audit::audit_hierarchy(input->levels, options);
  if (!report.complete) return cancelled();
  if (Status status = apply(demands, report); !status) return status.error();
  return report;
}

bool all_pass(const std::vector<audit::Report>& reports) {
  for (const audit::Report& report : reports)
    if (!report.pass()) return false;
  return true;
}

// One input is one object; several are in a list.
JsonWriter json_of(const std::vector<std::string>& paths,
                   const std::vector<audit::Report>& reports) {
  JsonWriter json;
  json.begin_object();
  if (reports.size() == 1) {
    append_audit_json(json, reports[0]);
    return json.end_object();
  }
  json.field("verdict", all_pass(reports) ? "pass" : "fail").key("inputs").begin_array();
  for (std::size_t i = 0; i < reports.size(); ++i) {
    json.begin_object().field("input", paths[i]);
    append_audit_json(json, reports[i]);
    json.end_object();
  }
  return json.end_array().end_object();
}

// The tables go where -o says, or to the terminal.
Status publish(const std::string& tables, Session& session) {
  if (!session.options().output.empty())
    return session.outputs().add(session.options().output, [&](TextWriter& out) { out << tables; });
  session.print(tables);
  return Ok{};
}

Result<int> run_audit(Arguments& arguments, Session& session) {
  const auto demands = read_demands(arguments, session);
  if (!demands) return demands.error();
  const std::vector<std::string>& paths = arguments.operands();
  if (paths.size() > 1 && !demands->vtu.empty())
    return Error{ErrorCode::kUsage, "audit: --vtu takes one input"};
  std::vector<audit::Report> reports;
  std::string tables;
  for (const std::string& path : paths) {
    auto report = is_directory(path) ? audit_directory(path, *demands, session)
                                     : audit_file(path, *demands, session);
    if (!report) return report.error();
    append(tables, {paths.size() > 1 ? concat({path, "\n"}) : "", audit_table(*report)});
    reports.push_back(std::move(*report));
  }
  if (Status status = publish(tables, session); !status) return status.error();
  if (Status status = session.write_json(json_of(paths, reports)); !status) return status.error();
  return all_pass(reports) ? kExitOk : kExitViolation;
}

}  // namespace

extern const Command kAudit;
const Command kAudit = {.name = "audit",
                        .operands = "FILE...",
                        .summary = "the verdict on a mesh: exact checks, measures, exit code 1",
                        .least_operands = 1,
                        .most_operands = 1000000,
                        .options = kAuditOptions,
                        .run = run_audit};

}  // namespace wellspaced::cli
