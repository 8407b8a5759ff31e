#include "wellspaced/algorithms/audit/transfer_audit.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace wellspaced {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Three nodes, of which 0 and 2 are kept and 1 lies half way.
SparseMatrix half_way() {
  SparseMatrix p;
  p.columns = 2;
  p.first = {0, 1, 3, 4};
  p.column = {0, 0, 1, 1};
  p.value = {1, 0.5, 0.5, 1};
  return p;
}

const std::vector<Index> kParent = {0, 2};

// The names of the checks that fail, each with its nodes.
std::string failures(const SparseMatrix& p, const std::vector<Index>& parent = kParent) {
  std::string text;
  for (const audit::Check& check : audit::audit_transfer(p, parent).checks) {
    if (check.pass()) continue;
    text.append(check.name).append(":");
    for (const Index v : check.ids) text.append(" ").append(std::to_string(v));
    text += ";";
  }
  return text;
}

TEST(AuditTransfer, PassesAPartitionOfUnity) { EXPECT_EQ(failures(half_way()), ""); }

TEST(AuditTransfer, FindsAMisshapenMatrix) {
  SparseMatrix p = half_way();
  p.columns = 3;
  EXPECT_EQ(failures(p), "transfer_shape:;");
  p = half_way();
  p.first[1] = 9;
  EXPECT_EQ(failures(p), "transfer_shape:;");
  p = half_way();
  p.value.pop_back();
  EXPECT_EQ(failures(p), "transfer_shape:;");
  EXPECT_EQ(failures(half_way(), {0, 3}), "transfer_shape:;");
}

TEST(AuditTransfer, FindsColumnsOutOfRangeOrOrder) {
  SparseMatrix p = half_way();
  p.column = {0, 1, 0, 1};
  EXPECT_EQ(failures(p), "transfer_columns: 1;");
  p.column = {0, 0, 2, 1};
  EXPECT_EQ(failures(p), "transfer_columns: 1;");
}

TEST(AuditTransfer, FindsWeightsThatAreNone) {
  SparseMatrix p = half_way();
  p.value = {1, -0.5, 1.5, 1};
  EXPECT_EQ(failures(p), "transfer_weights: 1;");
  p.value = {1, kNaN, 0.5, 1};
  EXPECT_EQ(failures(p), "transfer_weights: 1;transfer_row_sums: 1;");
}

TEST(AuditTransfer, FindsARowSumThreeUnitsOff) {
  SparseMatrix p = half_way();
  p.value[1] = 0.5 + 3 * 0x1p-53;
  EXPECT_EQ(failures(p), "transfer_row_sums: 1;");
}

TEST(AuditTransfer, FindsAnEmptyRowAndALostIdentity) {
  SparseMatrix p = half_way();
  p.first = {0, 0, 2, 3};
  p.column = {0, 1, 1};
  p.value = {0.5, 0.5, 1};
  EXPECT_EQ(failures(p), "transfer_row_sums: 0;transfer_rank: 0;");
  EXPECT_EQ(failures(half_way(), {0, 1}), "transfer_rank: 1;");
}

}  // namespace
}  // namespace wellspaced
