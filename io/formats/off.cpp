#include <utility>

#include "wellspaced/io/formats/surface.hpp"
#include "wellspaced/io/formats/surface_files.hpp"
#include "wellspaced/io/text/scanner.hpp"

namespace wellspaced {
namespace {

bool is_off_keyword(std::string_view word) {
  return word.size() >= 3 && word.substr(word.size() - 3) == "OFF" &&
         word.find_first_not_of("STCN4nOF") == std::string_view::npos;
}

class OffParser {
 public:
  OffParser(std::string_view text, const TextSource& source) : scanner_(text, source) {}

  Result<Geometry> parse();

 private:
  void read_keyword();
  void read_points(Index count);
  void read_faces(Index count);

  Scanner scanner_;
  Geometry geometry_;
};

// Leaves the scanner before the counts, which are the first line where the keyword is missing.
void OffParser::read_keyword() {
  if (!scanner_.require_line("the keyword OFF")) return;
  Scanner after = scanner_;
  const std::string_view keyword = after.word("keyword");
  if (!is_off_keyword(keyword)) return;
  scanner_ = after;
  if (keyword.find_first_of("4n") != std::string_view::npos)
    scanner_.fail(ErrorCode::kUnreadable, "only points with three coordinates are understood");
  if (!scanner_.more()) scanner_.require_line("the number of points");
  if (Scanner(scanner_).word("number of points") == "BINARY")
    scanner_.fail(ErrorCode::kUnreadable, "binary OFF files are not understood");
}

void OffParser::read_points(Index count) {
  geometry_.solid.points.reserve(count);
  for (Index i = 0; i < count && scanner_.next_record(count, "points"); ++i) {
    const double x = scanner_.number("x coordinate");
    const double y = scanner_.number("y coordinate");
    geometry_.solid.points.push_back({x, y, scanner_.number("z coordinate")});
  }
}

void OffParser::read_faces(Index count) {
  for (Index i = 0; i < count && scanner_.next_record(count, "faces"); ++i) {
    std::vector<Index> face;
    for (Index left = scanner_.count("corners", 0); left > 0 && scanner_.ok(); --left)
      face.push_back(scanner_.point(geometry_.solid.points.size(), 0));
    if (scanner_.ok()) add_face(geometry_, std::move(face), 0);
  }
}

Result<Geometry> OffParser::parse() {
  geometry_.dimension = 3;
  read_keyword();
  const Index points = scanner_.count("points", 3);
  const Index faces = scanner_.more() ? scanner_.count("faces", 2) : 0;
  read_points(points);
  read_faces(faces);
  if (scanner_.next_line())
    scanner_.fail(ErrorCode::kUnreadable, "more lines follow than the counts announce");
  if (!scanner_.ok()) return scanner_.error();
  lay_in_plane(geometry_);
  return std::move(geometry_);
}

void write_off_text(TextWriter& out, const Geometry& geometry) {
  const TetMesh& solid = geometry.solid;
  out << "OFF\n";
  out.comment("#", geometry.remark);
  out << solid.points.size() << ' ' << solid.facets.size() + geometry.polygons.size() << " 0\n";
  for (const auto& [x, y, z] : solid.points) out << x << ' ' << y << ' ' << z << '\n';
  for_each_face(geometry, [&](std::span<const Index> corners, int) {
    out << corners.size();
    for (const Index v : corners) out << ' ' << v;
    out << '\n';
  });
}

}  // namespace

Result<Geometry> parse_off(std::string_view text, const TextSource& source) {
  return OffParser(text, source).parse();
}

bool recognise_off(std::string_view text) {
  Scanner scanner(text, "");
  return scanner.next_line() && is_off_keyword(scanner.word("keyword"));
}

Status write_off(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  return write_surface(outputs, path, geometry, "an OFF file", write_off_text);
}

}  // namespace wellspaced
