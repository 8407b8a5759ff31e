#include <algorithm>
#include <array>
#include <utility>

#include "wellspaced/io/formats/surface.hpp"
#include "wellspaced/io/formats/surface_files.hpp"
#include "wellspaced/io/text/numbers.hpp"
#include "wellspaced/io/text/scanner.hpp"

namespace wellspaced {
namespace {

class ObjParser {
 public:
  ObjParser(std::string_view text, const TextSource& source) : scanner_(text, source) {}

  Result<Geometry> parse();

 private:
  void read_statement();
  void read_point();
  void read_group();
  void read_face();
  void read_polyline();
  std::vector<Index> read_corners();
  Index read_corner(std::string_view word);

  Scanner scanner_;
  Geometry geometry_;
  MarkerNumbering groups_{geometry_, 2};
  int group_ = 0;
};

void ObjParser::read_point() {
  const double x = scanner_.number("x coordinate");
  const double y = scanner_.number("y coordinate");
  geometry_.solid.points.push_back({x, y, scanner_.number("z coordinate")});
}

// "7", "7/2", "7//3", "7/2/3": the first is the point's number, from 1, or from the end if
// negative.
Index ObjParser::read_corner(std::string_view word) {
  const std::string_view digits = word.substr(0, word.find('/'));
  const auto number = parse_integer(digits);
  const auto count = static_cast<std::int64_t>(geometry_.solid.points.size());
  if (!number)
    scanner_.fail(ErrorCode::kUnreadable, {"the corner ", in_quotes(word), " is not an integer"});
  if (!number) return 0;
  const std::int64_t index = *number > 0 ? *number - 1 : count + *number;
  if (*number != 0 && index >= 0 && index < count) return static_cast<Index>(index);
  scanner_.fail(ErrorCode::kInvalidGeometry, {"point ", *number, " is not among the ", count,
                                              " points so far, which are numbered from 1"});
  return 0;
}

// A backslash at the end of a line joins the next one to it.
std::vector<Index> ObjParser::read_corners() {
  std::vector<Index> corners;
  while (scanner_.more()) {
    std::string_view word = scanner_.word("corner");
    const bool joins = word.back() == '\\' && !scanner_.more();
    if (joins) word.remove_suffix(1);
    if (!word.empty()) corners.push_back(read_corner(word));
    if (joins) scanner_.require_line("the rest of a joined line");
  }
  return corners;
}

void ObjParser::read_face() {
  std::vector<Index> corners = read_corners();
  if (corners.size() < 3) scanner_.fail(ErrorCode::kUnreadable, "a face has three corners or more");
  if (scanner_.ok()) add_face(geometry_, std::move(corners), group_);
}

void ObjParser::read_polyline() {
  const std::vector<Index> corners = read_corners();
  for (std::size_t i = 1; i < corners.size() && scanner_.ok(); ++i)
    geometry_.solid.segments.push_back({corners[i - 1], corners[i], group_});
}

void ObjParser::read_group() {
  const std::string_view name = scanner_.rest_of_line();
  group_ = name.empty() || name == "default" ? 0 : groups_.marker_of(name);
}

void ObjParser::read_statement() {
  const std::string_view keyword = scanner_.word("keyword");
  if (keyword == "v") read_point();
  if (keyword == "f") read_face();
  if (keyword == "l") read_polyline();
  if (keyword == "g") read_group();
}

Result<Geometry> ObjParser::parse() {
  geometry_.dimension = 3;
  geometry_.index_base = 1;
  while (scanner_.next_line()) read_statement();
  if (geometry_.solid.points.empty())
    scanner_.fail(ErrorCode::kUnreadable, "no vertex (a line \"v x y z\") is in the file");
  if (!scanner_.ok()) return scanner_.error();
  lay_in_plane(geometry_);
  return std::move(geometry_);
}

class ObjWriter {
 public:
  ObjWriter(TextWriter& out, const Geometry& geometry) : out_(out), geometry_(geometry) {}

  void write() {
    out_.comment("#", geometry_.remark);
    for (const auto& [x, y, z] : geometry_.solid.points)
      out_ << "v " << x << ' ' << y << ' ' << z << '\n';
    for_each_face(geometry_, [this](std::span<const Index> corners, int marker) {
      write_element('f', corners, marker);
    });
    for (const Segment& s : geometry_.solid.segments)
      write_element('l', std::array{s.a, s.b}, s.marker);
  }

 private:
  void write_element(char keyword, std::span<const Index> corners, int marker) {
    if (marker != group_)
      out_ << "g " << (marker == 0 ? "default" : marker_name(geometry_, 2, marker)) << '\n';
    group_ = marker;
    out_ << keyword;
    for (const Index v : corners) out_ << ' ' << std::uint64_t{v} + 1;
    out_ << '\n';
  }

  TextWriter& out_;
  const Geometry& geometry_;
  int group_ = 0;
};

}  // namespace

Result<Geometry> parse_obj(std::string_view text, const TextSource& source) {
  return ObjParser(text, source).parse();
}

bool recognise_obj(std::string_view text) {
  Scanner scanner(text, "");
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.word("keyword");
    if (keyword == "v") return scanner.count_fields() >= 3;
    constexpr std::array<std::string_view, 7> kOthers = {"o",  "g",      "s",     "vn",
                                                         "vt", "mtllib", "usemtl"};
    if (std::find(kOthers.begin(), kOthers.end(), keyword) == kOthers.end()) return false;
  }
  return false;
}

Status write_obj(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  return write_surface(outputs, path, geometry, "an OBJ file",
                       [](TextWriter& out, const Geometry& g) { ObjWriter(out, g).write(); });
}

}  // namespace wellspaced
