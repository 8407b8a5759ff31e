// Is a domain in space one that PACKING can mesh?
#pragma once

#include <cstddef>
#include <vector>

#include "wellspaced/algorithms/packing/space/feature_size3.hpp"
#include "wellspaced/algorithms/packing/space/polyhedral_complex.hpp"
#include "wellspaced/kernel/progress.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced {

/// Two polytopes that meet where they must not, or at less than 90 degrees.
///
/// place: a vertex, or an end of a segment, at which they meet; kNoIndex where they come together
/// but have no vertex in common. cosine: of the angle between them, 1 where they cross or coincide;
/// of two facets that meet in one vertex it may be a little less than that of the angle.
struct RuleViolation {
  FeatureSize3::Feature a, b;
  Index place = kNoIndex;
  double cosine = 1;
};

/// What is wrong with a complex, `most` faults at the most.
///
/// Axioms 2 and 3 of Definition 4.2.1: polytopes that have no vertex in common are further apart
/// than tolerance * extent, the diagonal of the box around the points. The 90 degree rule: two
/// polytopes that do, neither containing the other, make an angle there whose cosine is at most
/// `tolerance`; so those that intersect beside their vertex are found, too, at an angle of 0.
/// The tolerance stands for the rounding of coordinates: see kFlatness.
/// progress: phase "contacts"; told to stop, what was found by then.
/// Cost: O(n log n) for a domain that keeps the rule: at most six segments meet in a vertex then.
/// See: section 4.2.
std::vector<RuleViolation> find_rule_violations(const PolyhedralComplex& complex,
                                                const FeatureSize3& features, double tolerance,
                                                std::size_t most, const Progress& progress = {});

/// The faults as one error: how many, the worst with their polytopes and angles, and how many edges
/// bound one facet only, where a facet may be missing; polytopes by the domain's numbers (ids: the
/// points where they meet, or else those of the first polytope). Requires: at least one.
Error rule_error(const std::vector<RuleViolation>& violations, const PolyhedralComplex& complex);

}  // namespace wellspaced
