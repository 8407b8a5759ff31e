#include "wellspaced/algorithms/audit/requirement.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "wellspaced/algorithms/audit/shape.hpp"

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

bool is_broken_by(const Requirement& requirement, const TriangleShape& shape) {
  const auto value = shape_value(shape, requirement.name);
  return value && !requirement.holds(*value);
}

void list_triangles(const Requirement& requirement, const TriangleMesh& mesh, Check& check) {
  check.item = Item::kTriangle;
  check.violations = 0;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (is_broken_by(requirement, triangle_shape(mesh.points[a], mesh.points[b], mesh.points[c])))
      check.violate({t});
  }
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

void require_bound_of_measures(const Requirement& requirement, const TriangleMesh* mesh,
                               Report& report) {
  for (const Measure& measure : report.measures) {
    if (measure.name != requirement.name) continue;
    Check check = bound_check(requirement, measure.value, measure.level);
    const bool of_triangles = shape_value({}, requirement.name).has_value();
    if (!check.pass() && mesh != nullptr && of_triangles) {
      list_triangles(requirement, *mesh, check);
      if (check.pass()) check.violations = 1;  // broken by the rounding of the measure alone
    }
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

Status require(const Requirement& requirement, const TriangleMesh* mesh, Report& report) {
  if (requirement.relation == Relation::kPasses) {
    if (mark_required(requirement.name, report) || !report.pass()) return Ok{};
  } else {
    const std::size_t before = report.checks.size();
    require_bound_of_measures(requirement, mesh, report);
    if (report.checks.size() == before) require_bound_of_checks(requirement, report);
    if (report.checks.size() > before || !report.pass()) return Ok{};
  }
  return Error{ErrorCode::kUsage, requirement.name + " is no check or measure of this input", {}};
}

void require_all(Report& report) {
  for (Check& check : report.checks) check.required = true;
}

}  // namespace wellspaced::audit
