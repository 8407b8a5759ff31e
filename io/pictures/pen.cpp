#include "wellspaced/io/pictures/pen.hpp"

#include <algorithm>
#include <cmath>

#include "wellspaced/kernel/sort.hpp"

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
  // The last arc at `place` whose line is not taken, or null.
  const Arc* next_arc(Index place);
  bool is_odd(Index place) const;
  void draw_trail(Index start);
  void draw_circuit(Index start);
  void draw_line(Index from, Index to);

  std::vector<GridPoint> places_;
  std::vector<Index> first_, end_;
  std::vector<Arc> arcs_;
  std::vector<char> taken_;
  Index pen_ = kNoIndex;
  std::string data_;
};

Strokes::Strokes(std::vector<GridLine> lines) {
  for (GridLine& line : lines)
    if (line.b < line.a) std::swap(line.a, line.b);
  std::erase_if(lines, [](const GridLine& line) { return line.a == line.b; });
  sort_unique(lines);
  for (const GridLine& line : lines) places_.insert(places_.end(), {line.a, line.b});
  sort_unique(places_);

  std::vector<std::pair<Index, Arc>> arcs;
  for (Index i = 0; i < lines.size(); ++i) {
    const Index a = find(lines[i].a), b = find(lines[i].b);
    arcs.push_back({a, {b, i}});
    arcs.push_back({b, {a, i}});
  }
  first_.assign(places_.size() + 1, 0);
  for (const auto& [from, arc] : arcs) ++first_[from + 1];
  for (std::size_t v = 0; v < places_.size(); ++v) first_[v + 1] += first_[v];
  end_.assign(first_.begin(), first_.end() - 1);
  arcs_.resize(arcs.size());
  for (const auto& [from, arc] : arcs) arcs_[end_[from]++] = arc;
  taken_.assign(lines.size(), 0);
}

const Strokes::Arc* Strokes::next_arc(Index place) {
  Index& end = end_[place];
  while (end > first_[place] && taken_[arcs_[end - 1].line] != 0) --end;
  return end > first_[place] ? &arcs_[end - 1] : nullptr;
}

void append_number(int number, std::string& data) {
  const char last = data.empty() ? 'M' : data.back();
  if (number >= 0 && last >= '0' && last <= '9') data += ' ';
  data += std::to_string(number);
}

void Strokes::draw_line(Index from, Index to) {
  if (from != pen_) {
    data_ += 'M';
    append_number(places_[from].x, data_);
    append_number(places_[from].y, data_);
    data_ += 'l';
  }
  append_number(places_[to].x - places_[from].x, data_);
  append_number(places_[to].y - places_[from].y, data_);
  pen_ = to;
}

// From a place where an odd number of lines is left the pen ends at another such place.
void Strokes::draw_trail(Index start) {
  Index place = start;
  while (const Arc* arc = next_arc(place)) {
    taken_[arc->line] = 1;
    draw_line(place, arc->target);
    place = arc->target;
  }
}

// Hierholzer's walk around what is left, once every place has an even number of lines: on along
// lines not yet taken, and where there are none back, drawing.
void Strokes::draw_circuit(Index start) {
  std::vector<Index> way = {start};
  while (!way.empty()) {
    const Index place = way.back();
    if (const Arc* arc = next_arc(place)) {
      taken_[arc->line] = 1;
      way.push_back(arc->target);
    } else {
      way.pop_back();
      if (!way.empty()) draw_line(place, way.back());
    }
  }
}

bool Strokes::is_odd(Index place) const {
  Index left = 0;
  for (Index i = first_[place]; i < first_[place + 1]; ++i) left += taken_[arcs_[i].line] == 0;
  return left % 2 == 1;
}

std::string Strokes::draw() {
  const auto count = static_cast<Index>(places_.size());
  for (Index start = 0; start < count; ++start)
    if (is_odd(start)) draw_trail(start);
  for (Index start = 0; start < count; ++start)
    if (next_arc(start) != nullptr) draw_circuit(start);
  return std::move(data_);
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
