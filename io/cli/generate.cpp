// wellspaced generate: test meshes, domains and point sets.
#include <array>

#include "wellspaced/algorithms/generate/graded_mesh.hpp"
#include "wellspaced/algorithms/generate/grid.hpp"
#include "wellspaced/algorithms/generate/low_discrepancy.hpp"
#include "wellspaced/algorithms/generate/mis_degradation.hpp"
#include "wellspaced/algorithms/generate/point_sets.hpp"
#include "wellspaced/algorithms/generate/points3.hpp"
#include "wellspaced/algorithms/generate/well_spaced.hpp"
#include "wellspaced/io/cli/command.hpp"
#include "wellspaced/io/formats/formats.hpp"
#include "wellspaced/io/text/numbers.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced::cli {
namespace {

constexpr std::array<Option, 11> kGenerateOptions = {{
    {"--nodes", "N", "number of nodes or points (default 20000)"},
    {"--grading", "OCTAVES",
     "crack, annulus, airfoil, spiral, wellspaced: spacing grows by 2^OCTAVES"},
    {"--boundary", "", "crack, annulus, airfoil: the boundary alone, as a domain"},
    {"--tight", "", "wellspaced: balls touch, which leaves larger angles"},
    {"--nx", "N", "grid, lattice: nodes in a row (default 1000; lattice3: 50)"},
    {"--ny", "N", "grid, lattice: nodes in a column (default 1000; lattice3: 50)"},
    {"--nz", "N", "lattice3: layers (default 50)"},
    {"--aspect", "A", "grid: height of a cell of width 1 (default 1)"},
    {"--diagonals", "RULE", "grid: slash (default), alternating, random or mixed:P"},
    {"--shuffle", "", "point sets: in random order"},
    {"--levels", "K", "degradation: levels of the pattern of Figure 6.1, 1 to 8 (default 5)"},
}};

constexpr double kMostGenerated = 1 << 28;

struct GenerateRequest {
  Arguments& arguments;
  Session& session;

  std::size_t count(std::string_view option, std::int64_t otherwise) const {
    return static_cast<std::size_t>(
        arguments.integer(option, otherwise, between(1, kMostGenerated)));
  }
  std::size_t nodes() const { return count("--nodes", 20'000); }
  std::uint64_t seed() const { return session.options().seed; }
};

struct Kind {
  std::string_view name;
  std::string_view options;  // those that it takes, blanks around each
  Result<Geometry> (*make)(const GenerateRequest& request);
};

// The share of cells cut the other way; kMixed stands for random and mixed:P.
void read_diagonals(const GenerateRequest& request, GridOptions& options) {
  const std::string rule = request.arguments.text("--diagonals", "slash");
  constexpr std::string_view kMixed = "mixed:";
  if (rule == "slash") return;
  if (rule == "alternating") {
    options.diagonals = GridDiagonals::kAlternating;
    return;
  }
  options.diagonals = GridDiagonals::kMixed;
  if (rule == "random") return;
  const ParsedNumber share = rule.rfind(kMixed, 0) == 0
                                 ? parse_number(std::string_view(rule).substr(kMixed.size()))
                                 : ParsedNumber{};
  if (share.status != NumberStatus::kOk || !(share.value >= 0 && share.value <= 1))
    request.arguments.refuse("--diagonals",
                             "is none of slash, alternating, random, mixed:P (0 <= P <= 1)");
  options.mixed = share.value;
}

Result<Geometry> make_grid(const GenerateRequest& request) {
  GridOptions options;
  options.nx = static_cast<Index>(request.count("--nx", 1000));
  options.ny = static_cast<Index>(request.count("--ny", 1000));
  options.aspect = request.arguments.number("--aspect", 1, more_than(0));
  options.seed = request.seed();
  read_diagonals(request, options);
  if (Status status = request.arguments.status(); !status) return status.error();
  auto mesh = generate_grid(options, request.session.progress());
  if (!mesh) return mesh.error();
  return to_geometry(std::move(*mesh));
}

Result<Geometry> make_mis_degradation(const GenerateRequest& request) {
  const auto levels =
      static_cast<unsigned>(request.arguments.integer("--levels", 5, between(1, 8)));
  if (Status status = request.arguments.status(); !status) return status.error();
  auto mesh = generate_mis_degradation(levels);
  if (!mesh) return mesh.error();
  return to_geometry(std::move(*mesh));
}

Geometry domain_geometry(Pslg boundary) {
  Geometry geometry;
  geometry.mesh.points = std::move(boundary.points);
  geometry.mesh.segments = std::move(boundary.segments);
  geometry.holes = std::move(boundary.holes);
  return geometry;
}

template <GradedDomain domain>
Result<Geometry> make_graded(const GenerateRequest& request) {
  GradedMeshOptions options;
  options.nodes = static_cast<Index>(request.nodes());
  if (request.arguments.has("--grading"))
    options.octaves = request.arguments.number("--grading", 0, at_least(0));
  if (Status status = request.arguments.status(); !status) return status.error();
  const Progress progress = request.session.progress();
  if (request.arguments.has("--boundary")) {
    auto boundary = generate_graded_boundary(domain, options, progress);
    if (!boundary) return boundary.error();
    return domain_geometry(std::move(*boundary));
  }
  auto mesh = generate_graded_mesh(domain, options, progress);
  if (!mesh) return mesh.error();
  return to_geometry(std::move(*mesh));
}

Result<Geometry> make_well_spaced(const GenerateRequest& request) {
  WellSpacedOptions options;
  options.nodes = static_cast<Index>(request.nodes());
  options.octaves = request.arguments.number("--grading", 0, at_least(0));
  if (request.arguments.has("--tight")) options.style = WellSpacedStyle::kTight;
  if (Status status = request.arguments.status(); !status) return status.error();
  auto mesh = generate_well_spaced(options, request.session.progress());
  if (!mesh) return mesh.error();
  return to_geometry(std::move(*mesh));
}

Geometry points_geometry(std::vector<Point2> points) {
  Geometry geometry;
  geometry.mesh.points = std::move(points);
  return geometry;
}

Geometry points_geometry(std::vector<Point3> points) {
  Geometry geometry;
  geometry.dimension = 3;
  geometry.solid.points = std::move(points);
  return geometry;
}

// Makes the points once the options are known to be right.
template <class Make>
Result<Geometry> make_points(const GenerateRequest& request, Make make) {
  if (Status status = request.arguments.status(); !status) return status.error();
  const Progress progress = request.session.progress();
  auto points = make(progress);
  if (request.arguments.has("--shuffle")) shuffle_points(points, request.seed(), progress);
  if (request.session.stopped()) return cancelled();
  return points_geometry(std::move(points));
}

void check_product(const GenerateRequest& request, std::initializer_list<std::size_t> counts) {
  double product = 1;
  for (const std::size_t count : counts) product *= static_cast<double>(count);
  if (product > kMostGenerated)
    request.arguments.refuse("--nx", "times the other numbers is more than 2^28 points");
}

Result<Geometry> make_lattice(const GenerateRequest& request) {
  const std::size_t nx = request.count("--nx", 1000), ny = request.count("--ny", 1000);
  check_product(request, {nx, ny});
  return make_points(request, [&](const Progress& p) { return grid_points(nx, ny, p); });
}

Result<Geometry> make_lattice3(const GenerateRequest& request) {
  const std::size_t nx = request.count("--nx", 50), ny = request.count("--ny", 50),
                    nz = request.count("--nz", 50);
  check_product(request, {nx, ny, nz});
  return make_points(request, [&](const Progress& p) { return lattice_points3(nx, ny, nz, p); });
}

// 100 points a turn, and a hundredth of the radius between turns.
Result<Geometry> make_helix3(const GenerateRequest& request) {
  return make_points(
      request, [n = request.nodes()](const Progress& p) { return helix_points3(n, 100, 0.01, p); });
}

Result<Geometry> make_spiral(const GenerateRequest& request) {
  const std::size_t nodes = request.nodes();
  const double octaves = request.arguments.number("--grading", 40, between(0, 500));
  return make_points(request, [&](const Progress& p) { return spiral_points(nodes, octaves, p); });
}

constexpr std::string_view kGraded = " --nodes --grading --boundary ";
constexpr std::string_view kPoints = " --nodes --shuffle ";

constexpr std::array<Kind, 22> kKinds = {{
    {"grid", " --nx --ny --aspect --diagonals ", make_grid},
    {"crack", kGraded, make_graded<GradedDomain::kCrack>},
    {"annulus", kGraded, make_graded<GradedDomain::kAnnulus>},
    {"airfoil", kGraded, make_graded<GradedDomain::kAirfoil>},
    {"degradation", " --levels ", make_mis_degradation},
    {"wellspaced", " --nodes --grading --tight ", make_well_spaced},
    {"random", kPoints,
     [](const GenerateRequest& r) {
       return make_points(
           r, [n = r.nodes(), &r](const Progress& p) { return random_points(n, r.seed(), p); });
     }},
    {"clusters", kPoints,
     [](const GenerateRequest& r) {
       return make_points(r, [n = r.nodes(), &r](const Progress& p) {
         return clustered_points(n, 100, r.seed(), p);
       });
     }},
    {"circle", kPoints,  // a tenth of the points on it, the others inside
     [](const GenerateRequest& r) {
       return make_points(r, [n = r.nodes(), &r](const Progress& p) {
         return circle_points(n / 10, n - n / 10, r.seed(), p);
       });
     }},
    {"spiral", " --nodes --grading --shuffle ", make_spiral},
    {"lattice", " --nx --ny --shuffle ", make_lattice},
    {"parabola", kPoints,
     [](const GenerateRequest& r) {
       return make_points(r, [n = r.nodes()](const Progress& p) { return parabola_points(n, p); });
     }},
    {"collinear", kPoints,  // all but one
     [](const GenerateRequest& r) {
       return make_points(
           r, [n = r.nodes()](const Progress& p) { return collinear_points_and_one(n - 1, p); });
     }},
    {"hammersley", kPoints,
     [](const GenerateRequest& r) {
       return make_points(r,
                          [n = r.nodes()](const Progress& p) { return hammersley_points(n, p); });
     }},
    {"halton", kPoints,
     [](const GenerateRequest& r) {
       return make_points(r, [n = r.nodes()](const Progress& p) { return halton_points(n, p); });
     }},
    {"copies", kPoints,  // of 10 points
     [](const GenerateRequest& r) {
       return make_points(r, [n = r.nodes(), &r](const Progress& p) {
         return repeated_points(n, 10, r.seed(), p);
       });
     }},
    {"box3", kPoints,
     [](const GenerateRequest& r) {
       return make_points(
           r, [n = r.nodes(), &r](const Progress& p) { return box_points3(n, r.seed(), p); });
     }},
    {"lattice3", " --nx --ny --nz --shuffle ", make_lattice3},
    {"sphere3", kPoints,
     [](const GenerateRequest& r) {
       return make_points(
           r, [n = r.nodes(), &r](const Progress& p) { return sphere_points3(n, r.seed(), p); });
     }},
    {"moment3", kPoints,
     [](const GenerateRequest& r) {
       return make_points(r, [n = r.nodes()](const Progress& p) { return moment_points3(n, p); });
     }},
    {"lines3", kPoints,  // half of them on each
     [](const GenerateRequest& r) {
       return make_points(r, [n = r.nodes()](const Progress& p) { return line_points3(n / 2, p); });
     }},
    {"helix3", kPoints, make_helix3},
}};

std::string names_of_kinds() {
  std::string names;
  for (const Kind& kind : kKinds) names.append(names.empty() ? "" : ", ").append(kind.name);
  return names;
}

bool takes(const Kind& kind, std::string_view option) {
  std::string word(" ");
  word.append(option).append(" ");
  return kind.options.find(word) != kind.options.npos;
}

Result<const Kind*> find_kind(const Arguments& arguments) {
  const std::string& name = arguments.operands()[0];
  for (const Kind& kind : kKinds) {
    if (kind.name != name) continue;
    for (const Option& option : kGenerateOptions)
      if (arguments.has(option.name) && !takes(kind, option.name))
        return Error{ErrorCode::kUsage, {"generate: ", option.name, " is not for ", name}};
    return &kind;
  }
  return Error{ErrorCode::kUsage,
               {"generate: ", in_quotes(name), " is none of ", names_of_kinds()}};
}

Status write_summary(std::string_view kind, const Geometry& geometry, Session& session) {
  const std::size_t points = geometry.point_count(), triangles = geometry.mesh.triangles.size();
  session.print(concat({kind, ": ", points, " points, ", triangles, " triangles, ",
                        geometry.mesh.segments.size(), " segments\n"}));
  JsonWriter json;
  json.begin_object().field("kind", kind).field("points", points).field("triangles", triangles);
  json.field("segments", geometry.mesh.segments.size());
  json.field("seed", session.options().seed).end_object();
  return session.write_json(json);
}

Result<int> run_generate(Arguments& arguments, Session& session) {
  const auto kind = find_kind(arguments);
  if (!kind) return kind.error();
  if (session.options().output.empty())
    return Error{ErrorCode::kUsage, "generate: name the output with -o"};
  const auto geometry = (*kind)->make({arguments, session});
  if (!geometry) return geometry.error();
  const Status written = write_geometry(session.outputs(), session.options().output,
                                        session.options().format, *geometry);
  if (!written) return written.error();
  if (Status status = write_summary((*kind)->name, *geometry, session); !status)
    return status.error();
  return kExitOk;
}

}  // namespace

extern const Command kGenerate;
const Command kGenerate = {
    .name = "generate",
    .operands = "KIND",
    .summary =
        "make a test mesh (grid, crack, annulus, airfoil, degradation, wellspaced) or point set "
        "(random, "
        "clusters, "
        "circle, spiral, lattice, parabola, collinear, hammersley, halton, copies; in space box3, "
        "lattice3, sphere3, "
        "moment3, lines3, helix3)",
    .least_operands = 1,
    .most_operands = 1,
    .options = kGenerateOptions,
    .run = run_generate};

}  // namespace wellspaced::cli
