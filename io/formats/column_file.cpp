#include "wellspaced/io/formats/column_file.hpp"

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/text/scanner.hpp"

namespace wellspaced {

Result<std::vector<double>> read_column(const std::string& path, std::size_t count) {
  const auto text = read_input(path);
  if (!text) return text.error();
  std::vector<double> values;
  Scanner scanner(*text, path);
  while (scanner.next_line() && values.size() <= count) values.push_back(scanner.number("a value"));
  if (!scanner.ok()) return scanner.error();
  if (values.size() != count)
    return Error{ErrorCode::kUnreadable,
                 path + ": holds not one value for each of the " + std::to_string(count) + " nodes",
                 {}};
  return values;
}

}  // namespace wellspaced
