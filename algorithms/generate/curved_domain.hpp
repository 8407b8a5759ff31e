// Domains with curved boundaries and the grading of their meshes.
#pragma once

#include <functional>
#include <vector>

#include "wellspaced/kernel/mesh.hpp"

namespace wellspaced {

/// A planar domain: curves between corners, which bound or cut it, and how its mesh is graded.
///
/// Curves meet at corners only, at angles of at least 90 degrees within the domain. A closed curve
/// runs from a corner to the same corner. holes: a point in each bounded region left out.
/// grading: positive and 1-Lipschitz; the spacing of a mesh is a multiple of it.
struct CurvedDomain {
  struct Curve {
    Index from = 0, to = 0;
    int marker = 0;
    /// The curve by a parameter in [0, 1], at a speed that is bounded and seldom small.
    std::function<Point2(double)> point;
  };
  std::vector<Point2> corners;
  std::vector<Curve> curves;
  std::vector<Point2> holes;
  std::function<double(Point2)> grading;
};

/// The unit square with a crack from (0, 1/2) to (1/2, 1/2), graded towards its tip.
/// octaves: the spacing grows by the factor 2^octaves from the tip to the far corners.
/// Markers: 1 outer boundary, 2 crack. Requires: 0 <= octaves < 64, here and below.
CurvedDomain crack_domain(double octaves);

/// The ring between the circles of radius 1 and 8 around the origin, graded towards the inner one.
/// Markers: 1 outer circle, 2 inner circle.
CurvedDomain annulus_domain(double octaves);

/// The flow around a wing section of two elements, NACA 2412 of chord 1 and a flap of NACA 0012,
/// in a circle of radius 8; graded towards the four edges, less so towards the surfaces.
/// Markers: 1 outer circle, 2 main element, 3 flap.
CurvedDomain airfoil_domain(double octaves);

/// The domain's curves as chains of segments about 1.2 spacings long, the spacing being
/// scale * grading; corners keep their numbers. Every closed curve has at least 6 points.
/// Requires: scale > 0. Cost: linear in the points made.
Pslg discretize(const CurvedDomain& domain, double scale);

}  // namespace wellspaced
