// What a user demands of a report beyond the default: that a check passes, or a bound is kept.
#pragma once

#include <string>
#include <string_view>

#include "wellspaced/algorithms/audit/report.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::audit {

/// "constrained_delaunay": the check must pass. "min_angle>=15": the measure must keep the bound;
/// for the name of a check it is the number of its violations that is compared.
struct Requirement {
  enum class Relation { kPasses, kLess, kAtMost, kEqual, kAtLeast, kMore };
  std::string text;
  std::string name;
  Relation relation = Relation::kPasses;
  double bound = 0;

  bool holds(double value) const;
};

/// Reads NAME, or NAME, one of < <= == >= > and a number; blanks are legal between them.
/// Errors: kUsage.
Result<Requirement> parse_requirement(std::string_view text);

/// Marks the checks of that name as required; a bound becomes a required check named by its text,
/// one for each level where the report has levels. For a measure of the elements of the mesh that
/// the report is about (see TriangleShape, TetShape) its violations are the elements that break the
/// bound; otherwise there is one at most.
/// Errors: kUsage if the report has no check or measure of that name. A check that was not reached
/// because the syntax is wrong is no error: the report fails anyway.
Status require(const Requirement& requirement, const TriangleMesh& mesh, Report& report);
Status require(const Requirement& requirement, const TetMesh& mesh, Report& report);
Status require(const Requirement& requirement, Report& report);

/// Marks all checks as required.
void require_all(Report& report);

}  // namespace wellspaced::audit
