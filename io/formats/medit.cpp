#include "wellspaced/io/formats/medit.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

class MeditParser {
 public:
  MeditParser(std::string_view text, const TextSource& source)
      : scanner_(text, source, {.across_lines = true}) {}

  Result<Geometry> parse();

 private:
  void read_header();
  bool read_section();
  void read_vertices();
  void read_tets();
  template <std::size_t kCorners, class Add>
  void read_elements(const char* what, Add add);
  bool pass_over(std::string_view keyword);
  void pass_over_unknown(std::string_view keyword);

  Scanner scanner_;
  Geometry geometry_;
  std::int64_t dimension_ = 3;
  std::vector<int> point_markers_, tet_markers_;
};

void MeditParser::read_header() {
  if (scanner_.word("keyword MeshVersionFormatted") != "MeshVersionFormatted")
    scanner_.fail(ErrorCode::kUnreadable, "the keyword MeshVersionFormatted should stand first");
  const std::int64_t version = scanner_.integer("version");
  if (version < 1 || version > 4)
    scanner_.fail(ErrorCode::kUnreadable, {"version ", version, " is not known"});
}

void MeditParser::read_vertices() {
  const Index count = scanner_.count("vertices", static_cast<std::uint64_t>(dimension_) + 1);
  for (Index i = 0; i < count && scanner_.ok(); ++i) {
    const double x = scanner_.number("x coordinate");
    const double y = scanner_.number("y coordinate");
    const double z = dimension_ == 3 ? scanner_.number("z coordinate") : 0;
    geometry_.solid.points.push_back({x, y, z});
    point_markers_.push_back(scanner_.marker());
  }
}

// Calls `add` with the corners and the reference of each element.
template <std::size_t kCorners, class Add>
void MeditParser::read_elements(const char* what, Add add) {
  const Index count = scanner_.count(what, kCorners + 1);
  for (Index i = 0; i < count && scanner_.ok(); ++i) {
    std::array<Index, kCorners> corners{};
    for (Index& corner : corners) corner = scanner_.point(geometry_.solid.points.size(), 1);
    add(corners, scanner_.marker());
  }
}

// Whether `keyword` is known and its items, so many numbers each, are of no use here.
bool MeditParser::pass_over(std::string_view keyword) {
  struct Items {
    std::string_view keyword;
    std::uint64_t fields;
  };
  const auto dimension = static_cast<std::uint64_t>(dimension_);
  const std::array<Items, 12> known = {{{"Corners", 1},
                                        {"Ridges", 1},
                                        {"RequiredVertices", 1},
                                        {"RequiredEdges", 1},
                                        {"RequiredTriangles", 1},
                                        {"RequiredQuadrilaterals", 1},
                                        {"Normals", dimension},
                                        {"Tangents", dimension},
                                        {"NormalAtVertices", 2},
                                        {"NormalAtTriangleVertices", 3},
                                        {"TangentAtVertices", 2},
                                        {"TangentAtEdges", 3}}};
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const Items& items) { return items.keyword == keyword; });
  if (found == known.end()) return false;
  scanner_.skip_fields(std::size_t{scanner_.count("items", found->fields)} * found->fields);
  return true;
}

// Up to the next word that begins with a letter.
void MeditParser::pass_over_unknown(std::string_view keyword) {
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  if (!is_letter(keyword[0]))
    return scanner_.fail(ErrorCode::kUnreadable,
                         {in_quotes(keyword), " where a keyword should stand"});
  geometry_.notes.push_back(
      concat({scanner_.file(), ": ", in_quotes(keyword), " was passed over"}));
  while (scanner_.more()) {
    Scanner after = scanner_;
    if (is_letter(after.word("keyword")[0])) return;
    scanner_ = after;
  }
}

bool MeditParser::read_section() {
  if (!scanner_.more()) return false;
  const std::string_view keyword = scanner_.word("keyword");
  if (keyword == "End") return false;
  if (keyword == "Dimension") {
    dimension_ = scanner_.integer("dimension");
    if (dimension_ != 2 && dimension_ != 3)
      scanner_.fail(ErrorCode::kUnreadable, "the dimension is not 2 or 3");
  } else if (keyword == "Vertices") {
    read_vertices();
  } else if (keyword == "Edges") {
    read_elements<2>("edges", [this](const auto& c, int marker) {
      geometry_.solid.segments.push_back({c[0], c[1], marker});
    });
  } else if (keyword == "Triangles") {
    read_elements<3>("triangles", [this](const auto& c, int marker) {
      add_facet(geometry_, {{{c.begin(), c.end()}}, {}, marker});
    });
  } else if (keyword == "Quadrilaterals") {
    read_elements<4>("quadrilaterals", [this](const auto& c, int marker) {
      add_facet(geometry_, {{{c.begin(), c.end()}}, {}, marker});
    });
  } else if (keyword == "Tetrahedra") {
    read_tets();
  } else if (keyword == "Hexahedra" || keyword == "Prisms" || keyword == "Pyramids") {
    if (scanner_.count("elements", 0) > 0)
      scanner_.fail(ErrorCode::kUnreadable,
                    {keyword, " are not understood, only triangles and tetrahedra"});
  } else if (!pass_over(keyword)) {
    pass_over_unknown(keyword);
  }
  return scanner_.ok();
}

void MeditParser::read_tets() {
  read_elements<4>("tetrahedra", [this](const auto& corners, int marker) {
    geometry_.solid.tets.push_back(corners);
    tet_markers_.push_back(marker);
  });
}

Result<Geometry> MeditParser::parse() {
  geometry_.dimension = 3;
  geometry_.index_base = 1;
  read_header();
  while (read_section()) {
  }
  if (!scanner_.ok()) return scanner_.error();
  geometry_.solid.point_markers = without_zeros(std::move(point_markers_));
  set_cell_markers(geometry_, tet_markers_);
  lay_in_plane(geometry_);
  return std::move(geometry_);
}

class MeditWriter {
 public:
  MeditWriter(TextWriter& out, const Geometry& lifted, int dimension)
      : out_(out), geometry_(lifted), dimension_(dimension) {}

  void write();

 private:
  void write_vertices();
  void write_element(std::span<const Index> corners, int marker) {
    for (const Index v : corners) out_ << std::uint64_t{v} + 1 << ' ';
    out_ << marker << '\n';
  }
  void write_facets(std::size_t corners, const char* keyword);

  TextWriter& out_;
  const Geometry& geometry_;
  int dimension_;
};

void MeditWriter::write_vertices() {
  const TetMesh& solid = geometry_.solid;
  out_ << "Vertices\n" << solid.points.size() << '\n';
  for (std::size_t i = 0; i < solid.points.size(); ++i) {
    out_ << solid.points[i].x << ' ' << solid.points[i].y << ' ';
    if (dimension_ == 3) out_ << solid.points[i].z << ' ';
    out_ << (solid.point_markers.empty() ? 0 : solid.point_markers[i]) << '\n';
  }
}

void MeditWriter::write_facets(std::size_t corners, const char* keyword) {
  const auto fits = [&](const Pls::Facet& facet) { return facet.polygons[0].size() == corners; };
  const auto& polygons = geometry_.polygons;
  const auto count =
      static_cast<std::size_t>(std::count_if(polygons.begin(), polygons.end(), fits));
  if (count > 0) out_ << keyword << '\n' << count << '\n';
  for (const Pls::Facet& facet : polygons)
    if (fits(facet)) write_element(facet.polygons[0], facet.marker);
}

void MeditWriter::write() {
  const TetMesh& solid = geometry_.solid;
  out_ << "MeshVersionFormatted 2\nDimension " << dimension_ << '\n';
  out_.comment("#", geometry_.remark);
  write_vertices();
  if (!solid.segments.empty()) out_ << "Edges\n" << solid.segments.size() << '\n';
  for (const Segment& s : solid.segments) write_element(std::array{s.a, s.b}, s.marker);
  if (!solid.facets.empty()) out_ << "Triangles\n" << solid.facets.size() << '\n';
  for (const TetMesh::Facet& facet : solid.facets) write_element(facet.points, facet.marker);
  write_facets(3, "Triangles");
  write_facets(4, "Quadrilaterals");
  const std::vector<int> markers = cell_markers(geometry_);
  if (!solid.tets.empty()) out_ << "Tetrahedra\n" << solid.tets.size() << '\n';
  for (std::size_t t = 0; t < solid.tets.size(); ++t) write_element(solid.tets[t], markers[t]);
  out_ << "End\n";
}

}  // namespace

Result<Geometry> parse_medit(std::string_view text, const TextSource& source) {
  return MeditParser(text, source).parse();
}

bool recognise_medit(std::string_view text) {
  Scanner scanner(text, "");
  return scanner.next_line() && scanner.word("keyword") == "MeshVersionFormatted";
}

Status write_medit(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  const bool fits =
      std::all_of(geometry.polygons.begin(), geometry.polygons.end(), [](const Pls::Facet& facet) {
        return facet.polygons.size() == 1 && facet.holes.empty() && facet.polygons[0].size() <= 4 &&
               facet.polygons[0].size() >= 3;
      });
  if (!fits)
    return Error{ErrorCode::kUsage,
                 {path,
                  ": a Medit file has no place for facets of more than 4 corners or with "
                  "holes; write .poly"}};
  const Geometry lifted = lift_to_space(geometry);
  return outputs.add(
      path, [&](TextWriter& out) { MeditWriter(out, lifted, geometry.dimension).write(); });
}

}  // namespace wellspaced
