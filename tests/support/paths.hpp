// Where things are on the machine that runs the tests; the build writes it into paths.cpp alone.
#pragma once

namespace wellspaced::test {

extern const char* const kSourceDir;  ///< the checkout
extern const char* const kDataDir;    ///< the real meshes, unless $WELLSPACED_DATA says otherwise
extern const char* const kProgram;    ///< the command-line program; empty where it is not built

}  // namespace wellspaced::test
