#include "tests/support/paths.hpp"

namespace wellspaced::test {

const char* const kSourceDir = WELLSPACED_SOURCE_DIR;
const char* const kDataDir = WELLSPACED_DATA_DIR;
const char* const kProgram = WELLSPACED_PROGRAM;

}  // namespace wellspaced::test
