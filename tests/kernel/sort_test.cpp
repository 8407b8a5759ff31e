#include "wellspaced/kernel/sort.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/random.hpp"

namespace wellspaced {
namespace {

struct Named {
  std::uint64_t key = 0;
  Index place = 0;
};

std::vector<Named> named_at_random(std::size_t size, std::uint64_t keys) {
  Random random(size + keys);
  std::vector<Named> list(size);
  for (std::size_t i = 0; i < size; ++i) list[i] = {random.bits() % keys, static_cast<Index>(i)};
  return list;
}

TEST(Sort, AgreesWithTheStandardStableSortAtEverySizeAndNumberOfEquals) {
  const auto less = [](const Named& a, const Named& b) { return a.key < b.key; };
  for (std::size_t size = 0; size < 300; ++size)
    for (const std::uint64_t keys : {1u, 2u, 10u, 1u << 30}) {
      std::vector<Named> list = named_at_random(size, keys), expected = list;
      std::stable_sort(expected.begin(), expected.end(), less);
      sort(list, less);
      for (std::size_t i = 0; i < size; ++i) {
        ASSERT_EQ(list[i].key, expected[i].key);
        ASSERT_EQ(list[i].place, expected[i].place);
      }
    }
}

TEST(Sort, LeavesWhatIsSortedAndTurnsWhatDescends) {
  std::vector<int> ascending(1000);
  for (int i = 0; i < 1000; ++i) ascending[static_cast<std::size_t>(i)] = i;
  std::vector<int> list = ascending;
  sort(list);
  EXPECT_EQ(list, ascending);
  sort(list, std::greater<>());
  EXPECT_EQ(list, std::vector<int>(ascending.rbegin(), ascending.rend()));
  sort(list);
  EXPECT_EQ(list, ascending);
}

TEST(Sort, ComparesFewerThanTwiceAsOftenWhereAllIsSorted) {
  std::vector<int> list(4096);
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = static_cast<int>(i);
  std::size_t compared = 0;
  sort(list, [&](int a, int b) {
    ++compared;
    return a < b;
  });
  EXPECT_LT(compared, 2 * list.size());
}

TEST(Sort, TakesArraysAndPartsOfLists) {
  std::array<double, 3> triple{3, 1, 2};
  sort(triple);
  EXPECT_EQ(triple, (std::array<double, 3>{1, 2, 3}));
  std::vector<int> list{5, 4, 3, 2, 1};
  sort(std::span(list).subspan(1, 3));
  EXPECT_EQ(list, (std::vector<int>{5, 2, 3, 4, 1}));
}

TEST(Sort, MovesWhatCannotBeCopied) {
  std::vector<std::unique_ptr<int>> list;
  for (int i = 0; i < 100; ++i) list.push_back(std::make_unique<int>(37 * i % 100));
  sort(list, [](const auto& a, const auto& b) { return *a < *b; });
  for (int i = 0; i < 100; ++i) ASSERT_EQ(*list[static_cast<std::size_t>(i)], i);
}

TEST(SortUnique, KeepsOneOfEach) {
  std::vector<std::string> list{"c", "a", "c", "b", "a"};
  sort_unique(list);
  EXPECT_EQ(list, (std::vector<std::string>{"a", "b", "c"}));
  std::vector<int> none;
  sort_unique(none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace wellspaced
