#include "wellspaced/algorithms/audit/requirement.hpp"

#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "wellspaced/algorithms/audit/shape.hpp"
#include "wellspaced/algorithms/audit/tet_shape.hpp"

namespace wellspaced::audit {
namespace {

using Relation = Requirement::Relation;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool is_name(std::string_view text) {
  return !text.empty() &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == text.npos;
}

Error malformed(std::string_view text) {
  std::string message(text);
  message += " is neither a name nor a bound like min_angle>=15";
  return {ErrorCode::kUsage, std::move(message), {}};
}

// Longer ones first.
constexpr std::array<std::pair<std::string_view, Relation>, 5> kRelations = {
    {{"<=", Relation::kAtMost},
     {">=", Relation::kAtLeast},
     {"==", Relation::kEqual},
     {"<", Relation::kLess},
     {">", Relation::kMore}}};

bool parse_bound(std::string_view text, double& bound) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bound);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

// The elements of a mesh with their shapes.
struct NoElements {
  static constexpr Item kItem = Item::kNone;
  Index size() const { return 0; }
  static std::optional<double> value(Index, std::string_view) { return std::nullopt; }
  static bool measures(std::string_view) { return false; }
};

struct TriangleElements {
  static constexpr Item kItem = Item::kTriangle;
  const TriangleMesh& mesh;
  Index size() const { return static_cast<Index>(mesh.triangles.size()); }
  std::optional<double> value(Index t, std::string_view name) const {
    const auto& [a, b, c] = mesh.triangles[t];
    return shape_value(triangle_shape(mesh.points[a], mesh.points[b], mesh.points[c]), name);
  }
  static bool measures(std::string_view name) {
    return shape_value(TriangleShape{}, name).has_value();
  }
};

struct TetElements {
  static constexpr Item kItem = Item::kTet;
  const TetMesh& mesh;
  Index size() const { return static_cast<Index>(mesh.tets.size()); }
  std::optional<double> value(Index t, std::string_view name) const {
    const auto& [a, b, c, d] = mesh.tets[t];
    const auto& p = mesh.points;
    return shape_value(tet_shape({p[a], p[b], p[c], p[d]}), name);
  }
  static bool measures(std::string_view name) { return shape_value(TetShape{}, name).has_value(); }
};

template <class Elements>
void list_elements(const Requirement& requirement, const Elements& elements, Check& check) {
  check.item = Elements::kItem;
  check.violations = 0;
  for (Index t = 0; t < elements.size(); ++t) {
    const auto value = elements.value(t, requirement.name);
    if (value && !requirement.holds(*value)) check.violate({t});
  }
  if (check.pass()) check.violations = 1;  // broken by the rounding of the measure alone
}

Check bound_check(const Requirement& requirement, double value, std::optional<Index> level) {
  Check check;
  check.name = requirement.text;
  check.required = true;
  check.violations = requirement.holds(value) ? 0 : 1;
  check.value = value;
  check.level = level;
  return check;
}

template <class Elements>
void require_bound_of_measures(const Requirement& requirement, const Elements& elements,
                               Report& report) {
  for (const Measure& measure : report.measures) {
    if (measure.name != requirement.name) continue;
    Check check = bound_check(requirement, measure.value, measure.level);
    if (!check.pass() && Elements::measures(requirement.name))
      list_elements(requirement, elements, check);
    report.checks.push_back(std::move(check));
  }
}

void require_bound_of_checks(const Requirement& requirement, Report& report) {
  const std::size_t count = report.checks.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (report.checks[i].name != requirement.name) continue;
    const auto violations = static_cast<double>(report.checks[i].violations);
    report.checks.push_back(bound_check(requirement, violations, report.checks[i].level));
  }
}

bool mark_required(std::string_view name, Report& report) {
  bool found = false;
  for (Check& check : report.checks) {
    if (check.name != name) continue;
    check.required = true;
    found = true;
  }
  return found;
}

template <class Elements>
Status require_of(const Requirement& requirement, const Elements& elements, Report& report) {
  if (requirement.relation == Relation::kPasses) {
    if (mark_required(requirement.name, report) || !report.pass()) return Ok{};
  } else {
    const std::size_t before = report.checks.size();
    require_bound_of_measures(requirement, elements, report);
    if (report.checks.size() == before) require_bound_of_checks(requirement, report);
    if (report.checks.size() > before || !report.pass()) return Ok{};
  }
  return Error{ErrorCode::kUsage, {requirement.name, " is no check or measure of this input"}, {}};
}

}  // namespace

bool Requirement::holds(double value) const {
  switch (relation) {
    case Relation::kLess:
      return value < bound;
    case Relation::kAtMost:
      return value <= bound;
    case Relation::kEqual:
      return value == bound;
    case Relation::kAtLeast:
      return value >= bound;
    case Relation::kMore:
      return value > bound;
    case Relation::kPasses:
      break;
  }
  return true;
}

Result<Requirement> parse_requirement(std::string_view text) {
  Requirement requirement;
  requirement.text = trimmed(text);
  requirement.name = requirement.text;
  for (const auto& [word, relation] : kRelations) {
    const auto at = text.find(word);
    if (at == text.npos) continue;
    requirement.name = trimmed(text.substr(0, at));
    requirement.relation = relation;
    if (!parse_bound(trimmed(text.substr(at + word.size())), requirement.bound))
      return malformed(text);
    break;
  }
  if (!is_name(requirement.name)) return malformed(text);
  return requirement;
}

Status require(const Requirement& requirement, const TriangleMesh& mesh, Report& report) {
  return require_of(requirement, TriangleElements{mesh}, report);
}

Status require(const Requirement& requirement, const TetMesh& mesh, Report& report) {
  return require_of(requirement, TetElements{mesh}, report);
}

Status require(const Requirement& requirement, Report& report) {
  return require_of(requirement, NoElements{}, report);
}

void require_all(Report& report) {
  for (Check& check : report.checks) check.required = true;
}

}  // namespace wellspaced::audit
