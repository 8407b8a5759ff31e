#include "wellspaced/algorithms/audit/report.hpp"

#include <algorithm>
#include <array>

#include "wellspaced/kernel/quantifiers.hpp"
#include "wellspaced/kernel/sort.hpp"

namespace wellspaced::audit {
namespace {

template <class Named>
const Named* find(const std::vector<Named>& all, std::string_view name) {
  for (const Named& one : all)
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace

unsigned ids_per(Item item) {
  switch (item) {
    case Item::kNone:
      return 0;
    case Item::kEdge:
    case Item::kTrianglePair:
    case Item::kTetPair:
      return 2;
    case Item::kFace:
      return 3;
    default:
      return 1;
  }
}

std::string_view name_of(Item item) {
  switch (item) {
    case Item::kNone:
      return "nothing";
    case Item::kNode:
      return "node";
    case Item::kEdge:
      return "edge";
    case Item::kSegment:
      return "segment";
    case Item::kTriangle:
      return "triangle";
    case Item::kTrianglePair:
      return "triangle pair";
    case Item::kFace:
      return "face";
    case Item::kFacet:
      return "facet";
    case Item::kTet:
      return "tet";
    case Item::kTetPair:
      return "tet pair";
    case Item::kDomainPoint:
      return "domain point";
    case Item::kDomainSegment:
      return "domain segment";
  }
  return "nothing";
}

void sort_pairs(std::vector<Index>& ids) {
  std::vector<std::array<Index, 2>> pairs;
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2)
    pairs.push_back({std::min(ids[i], ids[i + 1]), std::max(ids[i], ids[i + 1])});
  sort(pairs);
  ids.clear();
  for (const auto& [a, b] : pairs) ids.insert(ids.end(), {a, b});
}

bool Report::pass() const {
  return complete &&
         all_of(checks, [](const Check& check) { return check.pass() || !check.required; });
}

const Check* Report::check(std::string_view name) const { return find(checks, name); }

const Measure* Report::measure(std::string_view name) const { return find(measures, name); }

Check& Report::add_check(std::string_view name, Item item) {
  Check& check = checks.emplace_back();
  check.name = name;
  check.item = item;
  return check;
}

Check& Report::add_required_check(std::string_view name, Item item) {
  Check& check = add_check(name, item);
  check.required = true;
  return check;
}

}  // namespace wellspaced::audit
