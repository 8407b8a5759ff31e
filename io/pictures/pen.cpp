#include "wellspaced/io/pictures/pen.hpp"

#include <algorithm>
#include <cmath>

namespace wellspaced {
namespace {

constexpr double kTallest = 4;

int rounded(double x) { return static_cast<int>(std::floor(x + 0.5)); }

// The lines at each place: a graph in compressed rows.
class Strokes {
 public:
  explicit Strokes(std::vector<GridLine> lines);

  std::string draw();

 private:
  struct Arc {
    Index target, line;
  };
  Index find(GridPoint p) const {
    return static_cast<Index>(std::lower_bound(places_.begin(), places_.end(), p) -
                              places_.begin());
  }
  // The next arc at `place` whose line is not drawn, or null.
  const Arc* next_arc(Index place);
  void draw_stroke(Index start, std::string& data);

  std::vector<GridPoint> places_;
  std::vector<Index> first_, next_;
  std::vector<Arc> arcs_;
  std::vector<char> drawn_;
};

Strokes::Strokes(std::vector<GridLine> lines) {
  for (GridLine& line : lines)
    if (line.b < line.a) std::swap(line.a, line.b);
  std::erase_if(lines, [](const GridLine& line) { return line.a == line.b; });
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  for (const GridLine& line : lines) places_.insert(places_.end(), {line.a, line.b});
  std::sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());

  std::vector<std::pair<Index, Arc>> arcs;
  for (Index i = 0; i < lines.size(); ++i) {
    const Index a = find(lines[i].a), b = find(lines[i].b);
    arcs.push_back({a, {b, i}});
    arcs.push_back({b, {a, i}});
  }
  first_.assign(places_.size() + 1, 0);
  for (const auto& [from, arc] : arcs) ++first_[from + 1];
  for (std::size_t v = 0; v < places_.size(); ++v) first_[v + 1] += first_[v];
  next_.assign(first_.begin(), first_.end() - 1);
  arcs_.resize(arcs.size());
  for (const auto& [from, arc] : arcs) arcs_[next_[from]++] = arc;
  next_.assign(first_.begin(), first_.end() - 1);
  drawn_.assign(lines.size(), 0);
}

const Strokes::Arc* Strokes::next_arc(Index place) {
  Index& next = next_[place];
  while (next < first_[place + 1] && drawn_[arcs_[next].line] != 0) ++next;
  return next < first_[place + 1] ? &arcs_[next] : nullptr;
}

void append_number(int number, std::string& data) {
  const char last = data.empty() ? 'M' : data.back();
  if (number >= 0 && last >= '0' && last <= '9') data += ' ';
  data += std::to_string(number);
}

void Strokes::draw_stroke(Index start, std::string& data) {
  data += 'M';
  append_number(places_[start].x, data);
  append_number(places_[start].y, data);
  data += 'l';
  Index place = start;
  while (const Arc* arc = next_arc(place)) {
    drawn_[arc->line] = 1;
    append_number(places_[arc->target].x - places_[place].x, data);
    append_number(places_[arc->target].y - places_[place].y, data);
    place = arc->target;
  }
}

std::string Strokes::draw() {
  std::string data;
  const auto count = static_cast<Index>(places_.size());
  for (Index start = 0; start < count; ++start)
    while (next_arc(start) != nullptr) draw_stroke(start, data);
  return data;
}

}  // namespace

Canvas::Canvas(std::span<const Point2> points, int width) : width_(width) {
  if (points.empty()) return;
  low_ = high_ = points[0];
  for (const Point2& p : points) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  low_ = {low_.x / 2, low_.y / 2};
  high_ = {high_.x / 2, high_.y / 2};
  const double extent = std::max(high_.x - low_.x, (high_.y - low_.y) / kTallest);
  scale_ = width / extent;
  if (!std::isfinite(scale_)) scale_ = 0;  // a single point, or next to it
  height_ = std::max(1, rounded((high_.y - low_.y) * scale_));
}

GridPoint Canvas::place(Point2 p) const {
  return {rounded((p.x / 2 - low_.x) * scale_), rounded((high_.y - p.y / 2) * scale_)};
}

std::string path_data(std::vector<GridLine> lines) { return Strokes(std::move(lines)).draw(); }

}  // namespace wellspaced
