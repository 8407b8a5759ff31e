// A mesh with its spacing function and what is claimed of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/mutation.hpp"
#include "wellspaced/algorithms/audit/requirement.hpp"
#include "wellspaced/algorithms/audit/vectors.hpp"
#include "wellspaced/algorithms/audit/well_spaced.hpp"

namespace wellspaced::test {

// The distance of each node from the nearest other place.
template <class Mesh>
std::vector<double> nearest_distances(const Mesh& mesh) {
  std::vector<double> distances;
  for (const auto& p : mesh.points) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& q : mesh.points)
      if (!(p == q))
        least =
            std::min(least, audit::distance_of(audit::coordinates_of(p), audit::coordinates_of(q)));
    distances.push_back(least);
  }
  return distances;
}

template <class Mesh>
struct SpacedMesh {
  Mesh mesh;
  std::vector<double> spacing;
  double beta = 0, gap = 0, boundary_distance = 0;
};

// What is claimed is what is measured by NN, and a hair more.
template <class Mesh>
SpacedMesh<Mesh> claim(const Mesh& mesh) {
  SpacedMesh<Mesh> spaced{mesh, nearest_distances(mesh)};
  audit::Report report;
  audit::audit_spacing(mesh, {spaced.spacing}, report);
  spaced.beta = report.measure("beta")->value * (1 + 1e-13);
  spaced.gap = report.measure("gap")->value * 1.01;
  spaced.boundary_distance = report.measure("boundary_distance")->value * (1 - 1e-13);
  return spaced;
}

// The claims on the gaps and on the distance from the boundary are the checks bounded_gaps and
// far_from_boundary.
template <class Mesh>
audit::Report audit_claims(const SpacedMesh<Mesh>& spaced) {
  audit::Report report;
  audit::audit_spacing(spaced.mesh, {spaced.spacing, spaced.beta}, report);
  using Relation = audit::Requirement::Relation;
  const audit::Requirement gap{"bounded_gaps", "gap", Relation::kAtMost, spaced.gap};
  const audit::Requirement far{"far_from_boundary", "boundary_distance", Relation::kAtLeast,
                               spaced.boundary_distance};
  if (report.measure("gap") != nullptr) {
    EXPECT_TRUE(audit::require(gap, report).ok());
    EXPECT_TRUE(audit::require(far, report).ok());
  }
  return report;
}

// What breaks a claim, in the plane and in space.
template <class Mesh>
struct ClaimBreakers {
  using Plant = bool (*)(SpacedMesh<Mesh>&, Random&);
  Plant break_beta, empty_a_ball, raise_a_value, push_to_the_boundary, swallow_a_node, lose_a_value;
};

// The faults, each with the checks that find it. optional: checks that clean inputs may fail.
template <class Mesh>
std::vector<Fault<SpacedMesh<Mesh>>> spacing_faults(const ClaimBreakers<Mesh>& plant,
                                                    const Names& optional) {
  return {{"node displaced to break beta by 1e-12",
           plant.break_beta,
           {"beta_spaced"},
           {"far_from_boundary", "lipschitz", "well_spaced", "spheres_empty"}},
          {"ball emptied", plant.empty_a_ball, {"bounded_gaps"}, {"beta_spaced", "spheres_empty"}},
          {"value raised to break Lipschitz by 1e-12",
           plant.raise_a_value,
           {"lipschitz", "well_spaced"},
           {"beta_spaced", "far_from_boundary"}},
          {"node pushed to the boundary",
           plant.push_to_the_boundary,
           {"far_from_boundary"},
           {"beta_spaced", "lipschitz", "well_spaced", "bounded_gaps", "spheres_empty"}},
          {"sphere that swallows a node", plant.swallow_a_node, {"spheres_empty"}, {}},
          {"value that is no spacing", plant.lose_a_value, {"spacing_positive"}, optional}};
}

}  // namespace wellspaced::test
