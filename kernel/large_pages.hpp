// Large pages of memory, where the system has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace wellspaced {

/// Asks the system to back reserved memory that has not been written yet with pages of 2 MB: it
/// then takes fewer page faults to fill, and fewer translations to read. A hint: results never
/// depend on it. Does nothing for less than two such pages, and outside Linux.
inline void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (address + kLargePage - 1) / kLargePage * kLargePage;
  const std::uintptr_t end = (address + bytes) / kLargePage * kLargePage;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

/// Memory of a vector in large pages. Elements that are given no value get none, as in T x;
template <class T>
struct LargePageAllocator {
  using value_type = T;

  LargePageAllocator() = default;
  template <class U>
  LargePageAllocator(const LargePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    T* const begin = std::allocator<T>().allocate(count);
    prefer_large_pages(begin, count * sizeof(T));
    return begin;
  }
  void deallocate(T* begin, std::size_t count) { std::allocator<T>().deallocate(begin, count); }

  void construct(T* at) { ::new (static_cast<void*>(at)) T; }
  template <class... Arguments>
  void construct(T* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) T{std::forward<Arguments>(arguments)...};
  }

  friend bool operator==(LargePageAllocator, LargePageAllocator) { return true; }
};

/// A vector of many elements, which resize leaves without a value.
template <class T>
using LargeVector = std::vector<T, LargePageAllocator<T>>;

/// Reserves memory in large pages for a vector that is to grow to `count` elements.
template <class T>
void reserve_large(std::vector<T>& vector, std::size_t count) {
  if (count <= vector.capacity()) return;
  vector.reserve(count);
  prefer_large_pages(vector.data(), vector.capacity() * sizeof(T));
}

/// vector.assign(count, value), in large pages.
template <class T>
void assign_large(std::vector<T>& vector, std::size_t count, const T& value = T()) {
  reserve_large(vector, count);
  vector.assign(count, value);
}

}  // namespace wellspaced
