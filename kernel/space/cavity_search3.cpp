#include "wellspaced/kernel/space/cavity_search3.hpp"

#include <algorithm>
#include <array>

#include "wellspaced/kernel/predicates.hpp"

namespace wellspaced {
namespace {

bool in_sphere(const Triangulation3& topology, std::span<const Point3> points, Index t, Point3 p) {
  const auto& v = topology.vertices(t);
  return insphere(points[v[1]], points[v[0]], points[v[2]], points[v[3]], p) > 0;
}

void grow(std::vector<Index>& buffer, std::size_t size) {
  if (buffer.size() < size) buffer.resize(size + size / 2);
}

bool lies_in_one_region(const std::array<Index, 4>& v, std::span<const std::uint8_t> region) {
  const auto first = region[v[0]];
  return region[v[1]] == first && region[v[2]] == first &&
         (v[3] == Triangulation3::kGhost || region[v[3]] == first);
}

// The insphere filter for several tets at once: the loop over them becomes vector instructions.
class SphereBatch {
 public:
  static constexpr std::size_t kSize = 16;

  void set(std::size_t i, const std::array<Index, 4>& v, const Point3* points, Point3 p) {
    set(i, 0, points[v[1]], p);
    set(i, 1, points[v[0]], p);
    set(i, 2, points[v[2]], p);
    set(i, 3, points[v[3] == Triangulation3::kGhost ? v[2] : v[3]],
        p);  // a flat tet, which the filter rejects
  }

  void evaluate(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto e = predicate_filter::insphere_of_differences(difference(i, 0), difference(i, 1),
                                                               difference(i, 2), difference(i, 3));
      determinant_[i] = e.determinant;
      bound_sq_[i] = e.bound_sq;
      sum_sq_[i] = e.sum_sq;
    }
  }

  bool is_certain(std::size_t i) const {
    return predicate_filter::InsphereEstimate{determinant_[i], bound_sq_[i], sum_sq_[i]}
        .is_certain();
  }
  bool is_inside(std::size_t i) const { return determinant_[i] > 0; }

 private:
  void set(std::size_t i, unsigned k, Point3 a, Point3 p) {
    x_[k][i] = a.x - p.x;
    y_[k][i] = a.y - p.y;
    z_[k][i] = a.z - p.z;
  }
  Point3 difference(std::size_t i, unsigned k) const { return {x_[k][i], y_[k][i], z_[k][i]}; }

  double x_[4][kSize], y_[4][kSize], z_[4][kSize];
  double determinant_[kSize], bound_sq_[kSize], sum_sq_[kSize];
};

}  // namespace

bool in_conflict(const Triangulation3& topology, std::span<const Point3> points, Index t,
                 Point3 p) {
  if (!topology.is_ghost(t)) return in_sphere(topology, points, t, p);
  const auto& v = topology.vertices(t);
  const int side = orient3d(points[v[0]], points[v[1]], points[v[2]], p);
  // On the plane, the circle is where it meets the sphere of the tet before the hull facet.
  return side < 0 || (side == 0 && in_sphere(topology, points, topology.neighbor(t, 3), p));
}

// Whether a tet was met or taken before cannot be predicted, so these loops store every candidate
// and let the count decide what stays.

void CavitySearch3::meet_neighbors(const Triangulation3& topology) {
  grow(met_, met_count_ + 4 * (taken_count_ - expanded_count_));
  Index* const met = met_.data();
  Mark* const mark = mark_.data();
  std::size_t count = met_count_;
  for (; expanded_count_ < taken_count_; ++expanded_count_) {
    for (const std::uint32_t link : topology.links(taken_[expanded_count_])) {
      const Index t = link >> 2;
      topology.prefetch(t);
      met[count] = t;
      count += !has(mark[t], kSeen);
      mark[t] = both(mark[t], kSeen);
    }
  }
  met_count_ = count;
}

// Returns whether no fenced tet was taken.
bool CavitySearch3::test_met(const Triangulation3& topology, std::span<const Point3> points,
                             Point3 p) {
  grow(taken_, taken_count_ + met_count_ - tested_count_);
  Index* const taken = taken_.data();
  Mark* const mark = mark_.data();
  SphereBatch batch;
  Mark taken_marks = kUnknown;
  while (tested_count_ < met_count_) {
    const Index* const met = met_.data() + tested_count_;
    const std::size_t count = std::min(SphereBatch::kSize, met_count_ - tested_count_);
    for (std::size_t i = 0; i < count; ++i)
      batch.set(i, topology.vertices(met[i]), points.data(), p);
    batch.evaluate(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Index t = met[i];
      const bool inside =
          batch.is_certain(i) ? batch.is_inside(i) : in_conflict(topology, points, t, p);
      taken[taken_count_] = t;
      taken_count_ += inside;
      const Mark marks = both(mark[t], static_cast<Mark>(inside * kTaken));
      mark[t] = marks;
      taken_marks = both(taken_marks, inside ? marks : kUnknown);
    }
    tested_count_ += count;
  }
  return !has(taken_marks, kFenced);
}

void CavitySearch3::collect_rim(const Triangulation3& topology,
                                std::vector<Triangulation3::RimFacet>& rim) {
  grow(rim_links_, 4 * taken_count_);
  std::uint32_t* const links = rim_links_.data();
  std::size_t count = 0;
  for (std::size_t j = 0; j < taken_count_; ++j) {
    for (unsigned i = 0; i < 4; ++i) {
      links[count] = taken_[j] << 2 | i;
      count += !has(mark_[topology.neighbor(taken_[j], i)], kTaken);
    }
  }
  rim.resize(count);
  for (std::size_t r = 0; r < count; ++r) {
    const Index t = links[r] >> 2;
    const unsigned i = links[r] & 3;
    rim[r] = {topology.vertices(t), topology.links(t)[i], i};
  }
}

bool CavitySearch3::run(const Triangulation3& topology, std::span<const Point3> points, Index root,
                        Point3 p, Triangulation3::Cavity& cavity) {
  if (mark_.size() < topology.size()) mark_.resize(topology.capacity());
  grow(taken_, 1);
  taken_[0] = root;
  mark_[root] = both(kSeen, kTaken);
  taken_count_ = 1;
  expanded_count_ = met_count_ = tested_count_ = 0;
  bool is_within = true;
  while (is_within && expanded_count_ < taken_count_) {
    meet_neighbors(topology);
    is_within = test_met(topology, points, p);
  }
  if (is_within) {
    collect_rim(topology, cavity.rim);
    cavity.tets.assign(taken_.begin(), taken_.begin() + static_cast<std::ptrdiff_t>(taken_count_));
  }
  const auto forget = [this](Index t) { mark_[t] = static_cast<Mark>(mark_[t] & kFenced); };
  forget(root);
  std::for_each_n(met_.begin(), met_count_, forget);
  return is_within;
}

void CavitySearch3::fence_off_borders(const Triangulation3& topology,
                                      std::span<const std::uint8_t> region_of_vertex) {
  mark_.resize(std::max<std::size_t>(mark_.size(), topology.capacity()));
  for (Index t = 0; t < topology.size(); ++t)
    if (!lies_in_one_region(topology.vertices(t), region_of_vertex)) mark_[t] = kFenced;
}

void CavitySearch3::remove_fence() { std::fill(mark_.begin(), mark_.end(), kUnknown); }

}  // namespace wellspaced
