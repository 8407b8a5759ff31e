#include "wellspaced/io/pictures/cut_away.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "wellspaced/algorithms/audit/tet_faces.hpp"
#include "wellspaced/io/pictures/pen.hpp"
#include "wellspaced/kernel/sort.hpp"
#include "wellspaced/kernel/space/box3.hpp"
#include "wellspaced/kernel/space/vector3.hpp"

namespace wellspaced {
namespace {

Point3 unit(Point3 a) {
  const double whole = length(a);
  return whole > 0 ? (1 / whole) * a : Point3{0, 0, 1};
}

// ---- The mesh near the origin --------------------------------------------------------------

// The points moved and scaled to a cube of side 2 around the origin.
std::vector<Point3> normalized(const std::vector<Point3>& points) {
  if (points.empty()) return {};
  const auto half = [](Point3 p) { return 0.5 * p; };
  const Box3 box = Box3::around(points);
  const Point3 low = half(box.low), size = half(box.high) - low, middle = low + 0.5 * size;
  const double extent = std::max({size.x, size.y, size.z}) / 2;
  std::vector<Point3> result;
  for (const Point3 p : points) {
    const Point3 q = half(p) - middle;
    result.push_back(extent > 0 ? Point3{q.x / extent, q.y / extent, q.z / extent} : Point3{});
  }
  return result;
}

struct Solid {
  std::vector<Point3> points;
  std::vector<std::array<Index, 4>> tets;  // none is flat
};

double sixfold_volume(const std::vector<Point3>& p, const std::array<Index, 4>& t) {
  return dot(p[t[1]] - p[t[0]], cross(p[t[2]] - p[t[0]], p[t[3]] - p[t[0]]));
}

Solid solid_of(const TetMesh& mesh) {
  Solid solid{normalized(mesh.points), {}};
  for (std::array<Index, 4> tet : mesh.tets) {
    const double volume = sixfold_volume(solid.points, tet);
    if (volume < 0) std::swap(tet[2], tet[3]);
    if (volume != 0) solid.tets.push_back(tet);
  }
  return solid;
}

// ---- What is seen --------------------------------------------------------------------------

Point3 middle_of(const Solid& solid, const std::array<Index, 4>& tet) {
  Point3 sum;
  for (const Index v : tet) sum = sum + solid.points[v];
  return 0.25 * sum;
}

// 1 for each tet whose middle is behind the plane.
std::vector<std::uint8_t> kept_tets(const Solid& solid, const CutAwayOptions& options) {
  const Point3 normal = unit(options.cut_normal);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& tet : solid.tets)
    for (const Index v : tet) {
      const double height = dot(normal, solid.points[v]);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  std::vector<std::uint8_t> kept;
  const double plane = high - options.cut * (high - low);
  for (const auto& tet : solid.tets)
    kept.push_back(options.cut <= 0 || dot(normal, middle_of(solid, tet)) <= plane);
  return kept;
}

// How near to the viewer the circumcentre is; the middle where that is no number.
double nearness_of(const Solid& solid, const std::array<Index, 4>& tet, Point3 viewer) {
  const Point3 a = solid.points[tet[0]], u = solid.points[tet[1]] - a, v = solid.points[tet[2]] - a,
               w = solid.points[tet[3]] - a;
  const double scale = 0.5 / dot(u, cross(v, w));
  const Point3 offset =
      scale * (dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v));
  const double nearness = dot(viewer, a + offset);
  return std::isfinite(nearness) ? nearness : dot(viewer, middle_of(solid, tet));
}

// ---- The picture ---------------------------------------------------------------------------

// The plane of the picture: to the right and up.
struct Screen {
  Point3 right, up, viewer;

  explicit Screen(Point3 from) : viewer(unit(from)) {
    const bool is_from_above = viewer.x == 0 && viewer.y == 0;
    right = unit(cross(is_from_above ? Point3{0, 1, 0} : Point3{0, 0, 1}, viewer));
    up = cross(viewer, right);
  }
  Point2 place(Point3 p) const { return {dot(right, p), dot(up, p)}; }
};

// A colour as light falls on it from above and the left of the viewer.
std::string shaded(const SeenFace& face, const Screen& screen) {
  constexpr std::array<double, 3> kOutside = {158, 202, 230}, kCut = {246, 190, 104};
  const Point3 light = unit(screen.viewer + 0.6 * screen.up - 0.5 * screen.right);
  const double share = 0.45 + 0.55 * std::max(0.0, dot(light, face.outwards));
  const auto& base = face.is_cut ? kCut : kOutside;
  std::string text = "#";
  for (const double part : base) {
    const int value = static_cast<int>(share * part);
    text += "0123456789abcdef"[value / 16];
    text += "0123456789abcdef"[value % 16];
  }
  return text;
}

void write_face(TextWriter& out, const std::array<GridPoint, 3>& at, const std::string& colour) {
  out << "<path fill=\"" << colour << "\" d=\"M" << at[0].x << ' ' << at[0].y;
  for (const int i : {1, 2}) out << 'L' << at[i].x << ' ' << at[i].y;
  out << "Z\"/>\n";
}

bool has_area(const std::array<GridPoint, 3>& at) {
  return std::int64_t{at[1].x - at[0].x} * (at[2].y - at[0].y) !=
         std::int64_t{at[2].x - at[0].x} * (at[1].y - at[0].y);
}

}  // namespace

std::vector<SeenFace> seen_faces(const TetMesh& mesh, const CutAwayOptions& options) {
  const Solid solid = solid_of(mesh);
  const std::vector<std::uint8_t> kept = kept_tets(solid, options);
  const auto twin =
      audit::pair_tet_faces(solid.tets, {}, static_cast<Index>(solid.points.size())).twin;
  const Point3 viewer = unit(options.from);
  struct Seen {
    double nearness;
    SeenFace face;
  };
  std::vector<Seen> seen;
  for (Index f = 0; f < twin.size(); ++f) {
    const auto& tet = solid.tets[f / 4];
    const bool is_boundary = twin[f] == kNoIndex;
    if (!kept[f / 4] || (!is_boundary && kept[twin[f] / 4])) continue;
    const auto corners = audit::face_nodes(solid.tets, f);
    const Point3 a = solid.points[corners[0]];
    const Point3 outwards = cross(solid.points[corners[1]] - a, solid.points[corners[2]] - a);
    if (dot(outwards, viewer) > 0)
      seen.push_back({nearness_of(solid, tet, viewer), {corners, !is_boundary, unit(outwards)}});
  }
  sort(seen, [](const Seen& a, const Seen& b) { return a.nearness < b.nearness; });
  std::vector<SeenFace> faces;
  for (const Seen& one : seen) faces.push_back(one.face);
  return faces;
}

void write_cut_away_svg(TextWriter& out, const TetMesh& mesh, const CutAwayOptions& options) {
  constexpr int kUnitsToAPixel = 10, kMarginOfSolid = 5 * kUnitsToAPixel;
  const Screen screen(options.from);
  const std::vector<Point3> points = normalized(mesh.points);
  const std::vector<SeenFace> faces = seen_faces(mesh, options);
  std::vector<Point2> places;
  for (const SeenFace& face : faces)
    for (const Index v : face.corners) places.push_back(screen.place(points[v]));
  const double pixels = std::clamp(options.width, 1.0, 1e6);
  const Canvas canvas(places, static_cast<int>(pixels) * kUnitsToAPixel);
  const int width = canvas.width() + 2 * kMarginOfSolid;
  const int height = canvas.height() + 2 * kMarginOfSolid;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width / double{kUnitsToAPixel}
      << "\" height=\"" << height / double{kUnitsToAPixel} << "\" viewBox=\"0 0 " << width << ' '
      << height << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      << "<g transform=\"translate(" << kMarginOfSolid << ' ' << kMarginOfSolid
      << ")\" stroke=\"#123\" stroke-width=\"" << options.line_width * kUnitsToAPixel
      << "\" stroke-linejoin=\"round\">\n";
  for (std::size_t k = 0; k < faces.size(); ++k) {
    std::array<GridPoint, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = canvas.place(places[3 * k + i]);
    if (has_area(at)) write_face(out, at, shaded(faces[k], screen));
  }
  out << "</g>\n</svg>\n";
}

}  // namespace wellspaced
