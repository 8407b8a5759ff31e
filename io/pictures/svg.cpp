#include "wellspaced/io/pictures/svg.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/io/pictures/pen.hpp"
#include "wellspaced/io/text/markup.hpp"
#include "wellspaced/kernel/sort_unique.hpp"

namespace wellspaced {
namespace {

constexpr int kUnits = 10;  // of the drawing grid, to a pixel
constexpr int kMargin = 5 * kUnits;
constexpr int kCaption = 24 * kUnits;

std::string edge_path(const TriangleMesh& mesh, const Canvas& canvas) {
  std::vector<GridLine> lines;
  lines.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const GridPoint a = canvas.place(mesh.points[t[0]]);
    const GridPoint b = canvas.place(mesh.points[t[1]]);
    const GridPoint c = canvas.place(mesh.points[t[2]]);
    lines.insert(lines.end(), {{a, b}, {b, c}, {c, a}});
  }
  return path_data(std::move(lines));
}

std::string segment_path(const TriangleMesh& mesh, const Canvas& canvas) {
  std::vector<GridLine> lines;
  for (const Segment& s : mesh.segments)
    lines.push_back({canvas.place(mesh.points[s.a]), canvas.place(mesh.points[s.b])});
  return path_data(std::move(lines));
}

// A dot of no length with round ends at each point.
std::string point_path(const TriangleMesh& mesh, const Canvas& canvas) {
  std::vector<GridPoint> places;
  for (const Point2& p : mesh.points) places.push_back(canvas.place(p));
  sort_unique(places);
  std::string data;
  for (const auto& [x, y] : places)
    data += 'M' + std::to_string(x) + ' ' + std::to_string(y) + "h0";
  return data;
}

void write_path(TextWriter& out, const std::string& data, const char* color, double width) {
  if (data.empty()) return;
  out << "<path fill=\"none\" stroke=\"" << color << "\" stroke-width=\"" << width
      << "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" "
         "vector-effect=\"non-scaling-stroke\" "
         "d=\""
      << data << "\"/>\n";
}

void draw(TextWriter& out, const TriangleMesh& mesh, const Canvas& canvas,
          const PictureOptions& options) {
  write_path(out, edge_path(mesh, canvas), "#456", options.line_width);
  write_path(out, segment_path(mesh, canvas), "#012", options.border_width);
  if (mesh.triangles.empty() && mesh.segments.empty())
    write_path(out, point_path(mesh, canvas), "#012", 2 * options.border_width);
}

// Opens a drawing of `width` x `height` grid units, on white.
void open_svg(TextWriter& out, int width, int height) {
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width / double{kUnits}
      << "\" height=\"" << height / double{kUnits} << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

int grid_width(const PictureOptions& options) {
  return static_cast<int>(std::clamp(options.width, 1.0, 1e6) * kUnits);
}

}  // namespace

void write_mesh_svg(TextWriter& out, const TriangleMesh& mesh, const PictureOptions& options) {
  const Canvas canvas(mesh.points, grid_width(options));
  open_svg(out, canvas.width() + 2 * kMargin, canvas.height() + 2 * kMargin);
  out << "<g transform=\"translate(" << kMargin << ' ' << kMargin << ")\">\n";
  draw(out, mesh, canvas, options);
  out << "</g>\n</svg>\n";
}

void write_panels_svg(TextWriter& out, std::span<const Panel> panels, std::size_t columns,
                      const PictureOptions& options) {
  static const std::vector<Point2> kNoPoints;
  const Canvas canvas(panels.empty() ? kNoPoints : panels[0].mesh->points, grid_width(options));
  const int width = canvas.width() + 2 * kMargin;
  const int height = canvas.height() + 2 * kMargin + kCaption;
  const auto wide = static_cast<int>(std::min(columns, panels.size()));
  const auto high = static_cast<int>((panels.size() + columns - 1) / columns);
  open_svg(out, wide * width, high * height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int x = static_cast<int>(i % columns) * width + kMargin;
    const int y = static_cast<int>(i / columns) * height + kMargin;
    out << "<g transform=\"translate(" << x << ' ' << y << ")\">\n";
    draw(out, *panels[i].mesh, canvas, options);
    out << "<text x=\"0\" y=\"" << canvas.height() + kCaption - kMargin << "\" font-size=\""
        << 14 * kUnits << "\" font-family=\"sans-serif\" fill=\"#012\">"
        << escape_markup(panels[i].caption) << "</text>\n</g>\n";
  }
  out << "</svg>\n";
}

}  // namespace wellspaced
