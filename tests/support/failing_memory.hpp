// An operator new that can be told to fail, and that counts what is in use.
#pragma once

#include <cstdint>

namespace wellspaced::test {

/// From now on the allocation number `which` fails (1: the next one), and all later ones do too
/// if `forever`.
enum class Failure { kOnce, kForever };
void fail_allocation(std::uint64_t which, Failure failure);

/// No allocation fails any more. Returns whether one did since fail_allocation().
bool stop_failing_allocations();

/// How many blocks are in use now.
std::int64_t blocks_in_use();

}  // namespace wellspaced::test
