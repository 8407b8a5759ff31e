// Whether the tests are built with AddressSanitizer.
#pragma once

namespace wellspaced::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WELLSPACED_ADDRESS_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define WELLSPACED_ADDRESS_SANITIZER
#endif

/// Its shadow takes terabytes of address space: no program that it watches can run in less.
#if defined(WELLSPACED_ADDRESS_SANITIZER)
inline constexpr bool kMemoryCanBeLimited = false;
#else
inline constexpr bool kMemoryCanBeLimited = true;
#endif

}  // namespace wellspaced::test
