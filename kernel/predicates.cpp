#include "wellspaced/kernel/predicates.hpp"

#include "wellspaced/kernel/exact_predicates.hpp"

namespace wellspaced::predicate_exact {

int compare_distances(const std::array<double, 6>& x) { return exact::compare_distances(x); }
int compare_distances(const std::array<double, 9>& x) { return exact::compare_distances(x); }
int orient2d(const std::array<double, 6>& x) { return exact::orient2d(x); }
int incircle(const std::array<double, 8>& x) { return exact::incircle(x); }
int orient3d(const std::array<double, 12>& x) { return exact::orient3d(x); }
int insphere(const std::array<double, 15>& x) { return exact::insphere(x); }

}  // namespace wellspaced::predicate_exact
