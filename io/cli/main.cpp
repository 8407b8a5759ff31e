#include <algorithm>
#include <string>
#include <vector>

#include "wellspaced/io/cli/process.hpp"
#include "wellspaced/io/cli/program.hpp"

int main(int count, char** words) {
  wellspaced::cli::catch_interrupts();
  const std::vector<std::string> list(words + std::min(count, 1), words + count);
  return wellspaced::cli::run_program(list);
}
