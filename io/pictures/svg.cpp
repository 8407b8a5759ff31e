#include "wellspaced/io/pictures/svg.hpp"

#include <algorithm>

#include "wellspaced/io/pictures/pen.hpp"
#include "wellspaced/io/text/markup.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced {
namespace {

constexpr int kUnits = 10;  // of the drawing grid, to a pixel
constexpr int kMargin = 5 * kUnits;
constexpr int kCaption = 24 * kUnits;

// What is shown of a canvas: from `low` on, all of it or a part.
struct Frame {
  Canvas canvas;
  GridPoint low;
  int width = 0, height = 0;

  // Whether the line may be seen, margins included.
  bool shows(const GridLine& line) const {
    const auto [left, right] = std::minmax(line.a.x, line.b.x);
    const auto [top, bottom] = std::minmax(line.a.y, line.b.y);
    return right >= low.x - kMargin && left <= low.x + width + kMargin &&
           bottom >= low.y - kMargin && top <= low.y + height + kMargin;
  }
};

std::string path_of(std::vector<GridLine> lines, const Frame& frame) {
  std::erase_if(lines, [&](const GridLine& line) { return !frame.shows(line); });
  return path_data(std::move(lines));
}

std::string edge_path(const TriangleMesh& mesh, const Frame& frame) {
  std::vector<GridLine> lines;
  lines.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const GridPoint a = frame.canvas.place(mesh.points[t[0]]);
    const GridPoint b = frame.canvas.place(mesh.points[t[1]]);
    const GridPoint c = frame.canvas.place(mesh.points[t[2]]);
    lines.insert(lines.end(), {{a, b}, {b, c}, {c, a}});
  }
  return path_of(std::move(lines), frame);
}

std::string segment_path(const TriangleMesh& mesh, const Frame& frame) {
  std::vector<GridLine> lines;
  for (const Segment& s : mesh.segments)
    lines.push_back({frame.canvas.place(mesh.points[s.a]), frame.canvas.place(mesh.points[s.b])});
  return path_of(std::move(lines), frame);
}

// A dot of no length with round ends at each point.
std::string point_path(const TriangleMesh& mesh, const Frame& frame) {
  std::vector<GridPoint> places;
  for (const Point2& p : mesh.points) {
    const GridPoint place = frame.canvas.place(p);
    if (frame.shows({place, place})) places.push_back(place);
  }
  sort_unique(places);
  std::string data;
  for (const auto& [x, y] : places) append(data, {'M', x, ' ', y, "h0"});
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

void draw(TextWriter& out, const TriangleMesh& mesh, const Frame& frame,
          const PictureOptions& options) {
  write_path(out, edge_path(mesh, frame), "#456", options.line_width);
  write_path(out, segment_path(mesh, frame), "#012", options.border_width);
  if (mesh.triangles.empty() && mesh.segments.empty())
    write_path(out, point_path(mesh, frame), "#012", 2 * options.border_width);
}

void draw_disks(TextWriter& out, std::span<const Point2> centres, std::span<const double> radii,
                const Frame& frame) {
  out << "<g fill=\"#0072b2\" fill-opacity=\".25\" stroke=\"#0072b2\" stroke-width=\"" << kUnits / 2
      << "\">\n";
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const GridPoint c = frame.canvas.place(centres[i]);
    const int edge = frame.canvas.place({centres[i].x + radii[i], centres[i].y}).x;
    const int radius = std::max(edge - c.x, kUnits / 2);
    if (frame.shows({{c.x - radius, c.y - radius}, {c.x + radius, c.y + radius}}))
      out << "<circle cx=\"" << c.x << "\" cy=\"" << c.y << "\" r=\"" << radius << "\"/>\n";
  }
  out << "</g>\n";
}

// Opens a drawing of `width` x `height` grid units, on white.
void open_svg(TextWriter& out, int width, int height) {
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width / double{kUnits}
      << "\" height=\"" << height / double{kUnits} << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

int grid_width(double pixels) { return static_cast<int>(std::clamp(pixels, 1.0, 1e6) * kUnits); }

Frame whole_frame(std::span<const Point2> points, const PictureOptions& options) {
  const Canvas canvas(points, grid_width(options.width));
  return {canvas, {}, canvas.width(), canvas.height()};
}

Point2 median_place(std::span<const Point2> points) {
  std::vector<double> xs, ys;
  for (const Point2& p : points) xs.push_back(p.x), ys.push_back(p.y);
  const auto middle = static_cast<std::ptrdiff_t>(points.size() / 2);
  std::nth_element(xs.begin(), xs.begin() + middle, xs.end());
  std::nth_element(ys.begin(), ys.begin() + middle, ys.end());
  return {xs[points.size() / 2], ys[points.size() / 2]};
}

Frame frame_of(std::span<const Point2> points, const PictureOptions& options) {
  if (!(options.zoom > 1) || points.empty()) return whole_frame(points, options);
  const Canvas canvas(points, grid_width(options.width * options.zoom));
  const int width = grid_width(options.width);
  const int height = std::max(1, static_cast<int>(canvas.height() / options.zoom));
  const auto [x, y] = canvas.place(options.centre ? *options.centre : median_place(points));
  return {canvas, {x - width / 2, y - height / 2}, width, height};
}

// The frame's part of a drawing, which `write` makes.
template <class Write>
void write_framed(TextWriter& out, const Frame& frame, Write write) {
  open_svg(out, frame.width + 2 * kMargin, frame.height + 2 * kMargin);
  out << "<g transform=\"translate(" << kMargin - frame.low.x << ' ' << kMargin - frame.low.y
      << ")\">\n";
  write();
  out << "</g>\n</svg>\n";
}

}  // namespace

void write_mesh_svg(TextWriter& out, const TriangleMesh& mesh, const PictureOptions& options) {
  const Frame frame = frame_of(mesh.points, options);
  write_framed(out, frame, [&] { draw(out, mesh, frame, options); });
}

void write_disks_svg(TextWriter& out, const TriangleMesh& mesh, std::span<const double> radii,
                     const PictureOptions& options) {
  const Frame frame = frame_of(mesh.points, options);
  write_framed(out, frame, [&] {
    write_path(out, edge_path(mesh, frame), "#9ab", options.line_width);
    write_path(out, segment_path(mesh, frame), "#012", options.border_width);
    draw_disks(out, mesh.points, radii, frame);
  });
}

void write_panels_svg(TextWriter& out, std::span<const Panel> panels, std::size_t columns,
                      const PictureOptions& options) {
  static const std::vector<Point2> kNoPoints;
  const Frame frame = whole_frame(panels.empty() ? kNoPoints : panels[0].mesh->points, options);
  const Canvas& canvas = frame.canvas;
  const int width = canvas.width() + 2 * kMargin;
  const int height = canvas.height() + 2 * kMargin + kCaption;
  const auto wide = static_cast<int>(std::min(columns, panels.size()));
  const auto high = static_cast<int>((panels.size() + columns - 1) / columns);
  open_svg(out, wide * width, high * height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int x = static_cast<int>(i % columns) * width + kMargin;
    const int y = static_cast<int>(i / columns) * height + kMargin;
    out << "<g transform=\"translate(" << x << ' ' << y << ")\">\n";
    draw(out, *panels[i].mesh, frame, options);
    out << "<text x=\"0\" y=\"" << canvas.height() + kCaption - kMargin << "\" font-size=\""
        << 14 * kUnits << "\" font-family=\"sans-serif\" fill=\"#012\">"
        << escape_markup(panels[i].caption) << "</text>\n</g>\n";
  }
  out << "</svg>\n";
}

}  // namespace wellspaced
