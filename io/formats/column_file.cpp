#include "wellspaced/io/formats/column_file.hpp"

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/triangle_files.hpp"
#include "wellspaced/io/text/numbers.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

constexpr std::string_view kPackingByLfs = "# packing by lfs, beta ",
                           kPackingBySize = "# packing by size, beta ";

}  // namespace

Result<std::vector<double>> read_column(const std::string& path, std::size_t count,
                                        const Progress& progress) {
  const auto text = read_input(path);
  if (!text) return text.error();
  std::vector<double> values;
  Scanner scanner(*text, {path, progress});
  while (scanner.next_line() && values.size() <= count) values.push_back(scanner.number("a value"));
  if (!scanner.ok()) return scanner.error();
  if (values.size() != count)
    return Error{ErrorCode::kUnreadable,
                 {path, ": holds not one value for each of the ", count, " nodes"}};
  return values;
}

Status write_spacing(OutputSet& outputs, const std::string& path, std::span<const double> values,
                     const PackingMark& mark) {
  return outputs.add(path, [&](TextWriter& out) {
    out << (mark.is_by_lfs ? kPackingByLfs : kPackingBySize) << mark.beta << '\n';
    for (const double value : values) out << value << '\n';
  });
}

std::optional<PackingMark> read_packing_mark(const std::string& path) {
  if (!file_exists(path)) return {};
  const auto text = read_input(path);
  if (!text) return {};
  const std::string_view line = std::string_view(*text).substr(0, text->find('\n'));
  for (const std::string_view mark : {kPackingByLfs, kPackingBySize}) {
    if (line.substr(0, mark.size()) != mark) continue;
    const ParsedNumber beta = parse_number(line.substr(mark.size()));
    if (beta.status == NumberStatus::kOk && beta.value > 0)
      return PackingMark{mark == kPackingByLfs, beta.value};
  }
  return {};
}

std::string spacing_beside(const std::string& path) {
  return concat({triangle_set_name(path), ".spacing"});
}

}  // namespace wellspaced
