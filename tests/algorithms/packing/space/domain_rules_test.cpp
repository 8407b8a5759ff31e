#include "wellspaced/algorithms/packing/space/domain_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/solids.hpp"

namespace wellspaced {
namespace {

struct Judged {
  PolyhedralComplex complex;
  std::vector<RuleViolation> violations;
};

Judged judged(const Pls& domain) {
  auto complex = build_complex(domain);
  EXPECT_TRUE(complex.ok()) << (complex.ok() ? "" : complex.error().message);
  if (!complex) return {};
  const FeatureSize3 features(*complex);
  auto violations = find_rule_violations(*complex, features, kFlatness, 100);
  return {std::move(*complex), std::move(violations)};
}

double degrees(double cosine) { return std::acos(cosine) * 180 / std::acos(-1.0); }

bool names(const RuleViolation& violation, unsigned dimension, Index number) {
  const FeatureSize3::Feature feature{dimension, number};
  return violation.a == feature || violation.b == feature;
}

TEST(DomainRules, AreMetByBoxesAndWhatIsInside) {
  for (const Pls& domain : {test::unit_cube(), test::triangulated_cube(), test::l_prism(),
                            test::two_boxes(), test::furnished_box()}) {
    EXPECT_TRUE(judged(domain).violations.empty());
    EXPECT_TRUE(judged(test::turned(domain)).violations.empty());
  }
}

TEST(DomainRules, AreMetByAnglesAboveNinetyDegrees) {
  EXPECT_TRUE(
      judged(test::prism({{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}}, 2))
          .violations.empty());
}

TEST(DomainRules, FindAnAngleOfThirtyDegreesBetweenFacets) {
  const Pls wedge = test::prism({{0, 0}, {2, 0}, {std::sqrt(3.0), 1}}, 1);
  const auto found = judged(wedge).violations;
  const auto is_wedge = [](const RuleViolation& v) { return names(v, 2, 2) && names(v, 2, 4); };
  const auto at = std::find_if(found.begin(), found.end(), is_wedge);
  ASSERT_NE(at, found.end());
  EXPECT_NEAR(degrees(at->cosine), 30, 1e-9);
  const Error error = rule_error(found, judged(wedge).complex);
  EXPECT_EQ(error.code, ErrorCode::kInvalidGeometry);
  EXPECT_NE(error.message.find(" meet at 30.00 degrees at point 0"), std::string::npos)
      << error.message;
}

TEST(DomainRules, FindASegmentThatLeavesAFacetAtFortyFiveDegrees) {
  Pls domain = test::unit_cube();
  domain.points.push_back({0.5, 0.5, 0.5});
  domain.segments.push_back({0, 8, 0});
  const auto found = judged(domain).violations;
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const RuleViolation& v) {
    return names(v, 2, 0) && v.place == 0 && std::fabs(degrees(v.cosine) - 35.2643896828) < 1e-6;
  }));
}

TEST(DomainRules, FindFacetsThatCoincide) {
  Pls domain = test::unit_cube();
  domain.facets.push_back(test::polygon({0, 1, 3, 2}, 9));
  const auto found = judged(domain).violations;
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const RuleViolation& v) {
    return names(v, 2, 0) && names(v, 2, 6) && v.cosine > 1 - 1e-12;
  }));
  const std::string message = rule_error(found, judged(domain).complex).message;
  EXPECT_EQ(message,
            "4 pairs of polytopes intersect or meet at less than 90 degrees: facet 0 and facet 6 "
            "overlap at point 0");
}

TEST(DomainRules, TellOfEdgesWhereAFacetMayBeMissing) {
  Pls domain = test::triangulated_cube();
  domain.facets.pop_back();
  const auto judgement = judged(domain);
  const std::string message = rule_error(judgement.violations, judgement.complex).message;
  EXPECT_NE(message.find("meet at 45.00 degrees"), message.npos) << message;
  EXPECT_NE(message.find("; 3 edges bound one facet only: is a facet missing?"), message.npos)
      << message;
}

TEST(DomainRules, FindBoxesThatIntersect) {
  for (const Point3 low : {Point3{0.5, 0.5, 0.5}, Point3{0.25, 0.25, 0.5}}) {
    Pls domain = test::unit_cube();
    test::add_box(domain, low, {low.x + 0.5, low.y + 0.5, low.z + 1});
    const auto judgement = judged(domain);
    ASSERT_FALSE(judgement.violations.empty());
    EXPECT_EQ(judgement.violations[0].place, kNoIndex);
    EXPECT_NE(rule_error(judgement.violations, judgement.complex).message.find("intersect"),
              std::string::npos);
  }
}

TEST(DomainRules, FindAPointOnAFacetThatDoesNotNameIt) {
  Pls domain = test::unit_cube();
  domain.points.push_back({0.25, 0.5, 0});
  const auto found = judged(domain).violations;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(names(found[0], 0, 8) && names(found[0], 2, 0));
  domain.facets[0].polygons.push_back({8});
  EXPECT_TRUE(judged(domain).violations.empty());
}

TEST(DomainRules, FindFacetsThatMeetInAVertexAlone) {
  // An octahedron's corner stands on the lid.
  Pls domain = test::box({-1, -1, -1}, {1, 1, 0});
  domain.points.insert(domain.points.end(), {{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0.5}});
  domain.facets[1].polygons.push_back({8});
  domain.facets.push_back(test::polygon({8, 9, 10}, 7));
  const auto found = judged(domain).violations;
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const RuleViolation& v) {
    return names(v, 2, 1) && names(v, 2, 6) && v.place == 8;
  }));
}

}  // namespace
}  // namespace wellspaced
