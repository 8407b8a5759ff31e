#include "tests/support/failing_memory.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> in_use{0};
std::atomic<std::uint64_t> allocations{0};
std::atomic<std::uint64_t> first_failure{0};  // 0: none fails
std::atomic<std::uint64_t> last_failure{0};
std::atomic<bool> failed{false};

bool fails() {
  const std::uint64_t number = ++allocations;
  const std::uint64_t first = first_failure;
  if (first == 0 || number < first || number > last_failure) return false;
  failed = true;
  return true;
}

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  if (fails()) return nullptr;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* const block = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (block != nullptr) ++in_use;
  return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  void* const block = allocate(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void release(void* block) noexcept {
  if (block != nullptr) --in_use;
  std::free(block);
}

constexpr std::size_t kAlignment = alignof(std::max_align_t);

}  // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size, kAlignment); }
void* operator new(std::size_t size, std::align_val_t a) {
  return allocate_or_throw(size, std::size_t(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, kAlignment);
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace wellspaced::test {

void fail_allocation(std::uint64_t which, Failure failure) {
  failed = false;
  allocations = 0;
  last_failure = failure == Failure::kOnce ? which : UINT64_MAX;
  first_failure = which;
}

bool stop_failing_allocations() {
  first_failure = 0;
  return failed;
}

std::int64_t blocks_in_use() { return in_use; }

}  // namespace wellspaced::test
