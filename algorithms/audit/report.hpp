// What an auditor found: named checks with the offending items, named measures, histograms.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::audit {

/// What the ids of a check number. All are 0-based, in the caller's numbering.
enum class Item {
  kNone,
  kNode,
  kEdge,          ///< two nodes
  kSegment,       ///< a segment of the mesh
  kTriangle,      ///< a triangle
  kTrianglePair,  ///< two triangles
  kFace,          ///< three nodes
  kFacet,         ///< a facet of the mesh or of the domain
  kTet,           ///< a tetrahedron
  kTetPair,       ///< two tetrahedra
  kDomainPoint,   ///< a point of the domain
  kDomainSegment  ///< a segment of the domain
};

/// The ids that one item takes.
unsigned ids_per(Item item);

/// The word for one such item in reports: "node", "edge", ...
std::string_view name_of(Item item);

/// Sorts a list of pairs of ids, the lower of each pair first.
void sort_pairs(std::vector<Index>& ids);

/// One check. It passes if there is no violation.
struct Check {
  std::string name;              ///< stable, snake_case
  bool required = false;         ///< whether the verdict depends on it
  bool promised = true;          ///< false where whoever made the input does not claim it
  std::uint64_t violations = 0;  ///< may exceed the items listed, where listing all costs too much
  Item item = Item::kNone;
  std::vector<Index> ids;       ///< ids_per(item) for each violation that is listed
  std::optional<double> value;  ///< the figure judged, where there is one
  std::optional<Index> level;   ///< the level of the hierarchy it speaks of

  bool pass() const { return violations == 0; }
  /// Counts one violation and lists its ids.
  void violate(std::initializer_list<Index> which) {
    ++violations;
    ids.insert(ids.end(), which);
  }
};

/// A number that is neither right nor wrong.
struct Measure {
  std::string name;
  double value = 0;
  std::optional<Index> level;
};

/// counts[i] items lie in [bounds[i], bounds[i+1]); the last interval is closed.
struct Histogram {
  std::string name;
  std::vector<double> bounds;
  std::vector<std::uint64_t> counts;
};

/// The worst items by some measure, the worst first; at most ten.
struct Worst {
  std::string measure;
  Item item = Item::kNone;
  std::vector<Index> ids;
  std::vector<double> values;
};

/// Where a measure comes from, in the caller's coordinates: a ball around `centre` with `at` on its
/// surface, or two places.
struct Witness {
  std::string name;
  std::vector<double> centre, at;
  std::optional<Index> level;  ///< as that of a check
};

/// An inequality of the thesis, left <= right if it holds, on the instance. If a hypothesis is
/// missing, the theorem says nothing here.
struct Theorem {
  std::string name, statement, missing_hypothesis;
  double left = 0, right = 0;
  bool holds = false;
  std::optional<Index> level;  ///< as that of a check

  bool applies() const { return missing_hypothesis.empty(); }
};

/// All that was found, in the order in which it was looked for.
struct Report {
  std::vector<Check> checks;
  std::vector<Measure> measures;
  std::vector<Histogram> histograms;
  std::vector<Worst> worst;
  std::vector<Witness> witnesses;
  std::vector<Theorem> theorems;
  bool complete = true;  ///< false: the caller's callback ended the audit before its end

  /// The verdict: every required check passes, and none is missing.
  bool pass() const;
  /// The first check, or measure, of this name; null if there is none.
  const Check* check(std::string_view name) const;
  const Measure* measure(std::string_view name) const;

  /// Appends an empty check. The reference dies with the next one appended.
  Check& add_check(std::string_view name, Item item);
  Check& add_required_check(std::string_view name, Item item);
  void add_measure(std::string_view name, double value) {
    measures.push_back({std::string(name), value, std::nullopt});
  }
};

}  // namespace wellspaced::audit
