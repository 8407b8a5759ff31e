#include "wellspaced/io/formats/matrix_files.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "tests/support/temporary_directory.hpp"
#include "wellspaced/io/text/bytes.hpp"

namespace wellspaced {
namespace {

// 3 rows, 2 columns, the second row empty.
SparseMatrix small_matrix() {
  SparseMatrix matrix;
  matrix.columns = 2;
  matrix.first = {0, 2, 2, 3};
  matrix.column = {0, 1, 1};
  matrix.value = {0.1, 1.0 / 3, 1};
  return matrix;
}

std::string bytes_of(const char* format) {
  const MatrixFormat* found = find_matrix_format(format);
  return found == nullptr ? "" : found->bytes(small_matrix());
}

TEST(MatrixFiles, MatrixMarketCountsFromOneAndIsExact) {
  EXPECT_EQ(bytes_of("mtx"),
            "%%MatrixMarket matrix coordinate real general\n3 2 3\n"
            "1 1 0.1\n1 2 0.3333333333333333\n3 2 1\n");
  EXPECT_EQ(std::stod("0.3333333333333333"), 1.0 / 3);
}

TEST(MatrixFiles, PetscIsBigEndianWithRowLengthsFirst) {
  const std::string bytes = bytes_of("petsc");
  const std::int32_t expected[] = {1211216, 3, 2, 3, 2, 0, 1, 0, 1, 1};
  ASSERT_EQ(bytes.size(), sizeof expected + 3 * sizeof(double));
  for (std::size_t i = 0; i < std::size(expected); ++i)
    EXPECT_EQ(read_bytes<std::int32_t>(bytes, 4 * i, std::endian::big), expected[i]) << i;
  EXPECT_EQ(read_bytes<double>(bytes, sizeof expected + 8, std::endian::big), 1.0 / 3);
}

// A reader of stored archives of its own.
struct Entry {
  std::string name, data;
  std::uint32_t crc = 0;
};

std::vector<Entry> entries_of(const std::string& zip) {
  std::vector<Entry> entries;
  std::size_t at = 0;
  while (zip.compare(at, 4, "PK\3\4") == 0) {
    const auto size = read_bytes<std::uint32_t>(zip, at + 18);
    const auto name = read_bytes<std::uint16_t>(zip, at + 26);
    entries.push_back({zip.substr(at + 30, name), zip.substr(at + 30 + name, size),
                       read_bytes<std::uint32_t>(zip, at + 14)});
    at += 30 + name + size;
  }
  EXPECT_EQ(zip.compare(at, 4, "PK\1\2"), 0);
  const std::size_t end = zip.size() - 22;
  EXPECT_EQ(zip.compare(end, 4, "PK\5\6"), 0);
  EXPECT_EQ(read_bytes<std::uint16_t>(zip, end + 10), entries.size());
  EXPECT_EQ(read_bytes<std::uint32_t>(zip, end + 12), end - at);
  EXPECT_EQ(read_bytes<std::uint32_t>(zip, end + 16), at);
  return entries;
}

TEST(MatrixFiles, NpzHoldsTheArraysOfACompressedRowMatrix) {
  const std::vector<Entry> entries = entries_of(bytes_of("npz"));
  ASSERT_EQ(entries.size(), 5u);
  const char* const names[] = {"indices.npy", "indptr.npy", "format.npy", "shape.npy", "data.npy"};
  const std::size_t sizes[] = {12, 16, 3, 16, 24};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(entries[i].name, names[i]);
    EXPECT_EQ(entries[i].data.compare(0, 6, "\x93NUMPY"), 0);
    EXPECT_EQ((entries[i].data.size() - sizes[i]) % 64, 0u) << names[i];
  }
  EXPECT_EQ(entries[2].data.substr(entries[2].data.size() - 3), "csr");
  const std::string& data = entries[4].data;
  EXPECT_EQ(read_bytes<double>(data, data.size() - 16), 1.0 / 3);
  EXPECT_NE(data.find("'descr': '<f8', 'fortran_order': False, 'shape': (3,)"), std::string::npos);
}

TEST(MatrixFiles, KnowsItsFormatsByName) {
  EXPECT_EQ(find_matrix_format("mat"), nullptr);
  for (const MatrixFormat& format : matrix_formats())
    EXPECT_EQ(find_matrix_format(format.name), &format);
}

}  // namespace
}  // namespace wellspaced
