#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/text/base64.hpp"
#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/io/text/inflate.hpp"
#include "wellspaced/io/text/markup_reader.hpp"
#include "wellspaced/io/text/numbers.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

// A DataArray as it stands in the file.
struct VtuArray {
  std::string_view section, name, type, format, text;
  std::uint64_t offset = 0;  // of an appended one
  std::uint64_t components = 1;
  std::uint64_t line = 0;
};

// Bytes that are counted out: what follows can be decoded from the rest.
struct VtuBlock {
  std::string bytes;
  bool good = false;
};

class VtuParser {
 public:
  VtuParser(std::string_view text, const TextSource& source) : reader_(text), source_(source) {}

  Result<Geometry> parse();

 private:
  struct Piece {
    std::uint64_t points = 0, cells = 0;
    std::vector<VtuArray> arrays;
  };

  void read_tags();
  void read_root(const MarkupTag& tag);
  void read_piece(const MarkupTag& tag);
  void read_array(const MarkupTag& tag);
  void read_appended(const MarkupTag& tag);

  void add_piece(const Piece& piece);
  void add_points(const VtuArray& array, const Piece& piece);
  void add_cells(const VtuArray& array, const Piece& piece, std::int64_t first_point,
                 std::int64_t first_corner);
  void add_field(const VtuArray& array, std::uint64_t count, std::vector<VtkField>& fields,
                 std::size_t before);
  std::vector<double> values(const VtuArray& array, std::uint64_t count);
  std::vector<std::int64_t> integers(const VtuArray& array, std::uint64_t count);
  std::vector<double> ascii_values(const VtuArray& array, std::uint64_t count);
  std::string bytes_of(const VtuArray& array);
  VtuBlock decode(std::string_view data, bool base64) const;
  VtuBlock decode_plain(std::string_view data, bool base64) const;
  VtuBlock decode_compressed(std::string_view data, bool base64) const;
  std::uint64_t header(std::string_view bytes, std::size_t i) const;
  std::uint64_t attribute_number(const MarkupTag& tag, std::string_view key,
                                 std::uint64_t otherwise);
  [[gnu::cold]] void fail(std::uint64_t line, std::string_view message,
                          ErrorCode code = ErrorCode::kUnreadable);
  bool ok() const { return !error_; }

  MarkupReader reader_;
  const TextSource& source_;
  std::optional<Error> error_;
  std::endian order_ = std::endian::little;
  std::size_t header_size_ = 4;
  bool compressed_ = false, has_root_ = false, appended_base64_ = false;
  std::string_view section_, appended_;
  std::vector<Piece> pieces_;
  VtkGrid grid_;
};

void VtuParser::fail(std::uint64_t line, std::string_view message, ErrorCode code) {
  if (ok()) error_ = Error{code, {source_.name, ":", line, ": ", message}};
}

std::uint64_t VtuParser::attribute_number(const MarkupTag& tag, std::string_view key,
                                          std::uint64_t otherwise) {
  const auto text = tag.attribute(key);
  if (!text) return otherwise;
  const auto value = parse_integer(*text);
  if (value && *value >= 0 && *value < kNoIndex) return static_cast<std::uint64_t>(*value);
  fail(tag.line, concat({key, " is ", in_quotes(*text), ", which makes no sense"}));
  return otherwise;
}

// ---- The tags ------------------------------------------------------------------------------

void VtuParser::read_root(const MarkupTag& tag) {
  has_root_ = true;
  if (tag.attribute("type").value_or("") != "UnstructuredGrid")
    fail(tag.line, "only VTK files of type UnstructuredGrid are understood");
  if (tag.attribute("byte_order").value_or("") == "BigEndian") order_ = std::endian::big;
  header_size_ = tag.attribute("header_type").value_or("") == "UInt64" ? 8 : 4;
  const std::string_view compressor = tag.attribute("compressor").value_or("");
  compressed_ = !compressor.empty();
  if (compressed_ && compressor != "vtkZLibDataCompressor")
    fail(tag.line, concat({"the compressor ", in_quotes(compressor),
                           " is not known, only vtkZLibDataCompressor"}));
}

void VtuParser::read_piece(const MarkupTag& tag) {
  Piece piece;
  piece.points = attribute_number(tag, "NumberOfPoints", 0);
  piece.cells = attribute_number(tag, "NumberOfCells", 0);
  pieces_.push_back(std::move(piece));
}

void VtuParser::read_array(const MarkupTag& tag) {
  if (pieces_.empty()) return;  // data of the whole file, which are not wanted
  VtuArray array;
  array.section = section_;
  array.name = tag.attribute("Name").value_or("");
  array.type = tag.attribute("type").value_or("");
  array.format = tag.attribute("format").value_or("ascii");
  array.components = attribute_number(tag, "NumberOfComponents", 1);
  array.line = tag.line;
  if (array.format == "appended") {
    const auto offset = parse_integer(tag.attribute("offset").value_or("x"));
    if (!offset || *offset < 0) fail(tag.line, "an appended array without offset");
    array.offset = static_cast<std::uint64_t>(offset.value_or(0));
  } else if (!tag.empty) {
    array.text = reader_.text();
  }
  pieces_.back().arrays.push_back(array);
}

void VtuParser::read_appended(const MarkupTag& tag) {
  appended_base64_ = tag.attribute("encoding").value_or("raw") == "base64";
  appended_ = reader_.rest();
  const std::size_t mark = appended_.find('_');
  if (mark == std::string_view::npos) fail(tag.line, "the appended data do not begin with '_'");
  appended_.remove_prefix(mark == std::string_view::npos ? appended_.size() : mark + 1);
}

void VtuParser::read_tags() {
  constexpr std::array<std::string_view, 4> kSections = {"Points", "Cells", "PointData",
                                                         "CellData"};
  while (const auto tag = reader_.next_tag()) {
    if (tag->name == "VTKFile") read_root(*tag);
    if (tag->name == "Piece") read_piece(*tag);
    if (std::find(kSections.begin(), kSections.end(), tag->name) != kSections.end())
      section_ = tag->name;
    if (tag->name == "DataArray") read_array(*tag);
    if (tag->name == "AppendedData") return read_appended(*tag);
  }
  if (!reader_.at_end()) fail(reader_.line(), "a tag does not end");
}

// ---- The arrays ----------------------------------------------------------------------------

std::uint64_t VtuParser::header(std::string_view bytes, std::size_t i) const {
  if (header_size_ == 8) return read_bytes<std::uint64_t>(bytes, 8 * i, order_);
  return read_bytes<std::uint32_t>(bytes, 4 * i, order_);
}

constexpr std::uint64_t base64_size(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

// The first `size` bytes of the data.
VtuBlock leading_bytes(std::string_view data, std::uint64_t size, bool base64) {
  const std::uint64_t coded = base64 && size < data.size() ? base64_size(size) : size;
  if (size > data.size() || coded > data.size()) return {};
  const std::string_view piece = data.substr(0, static_cast<std::size_t>(coded));
  if (!base64) return {std::string(piece), true};
  auto bytes = decode_base64(piece);
  if (!bytes || bytes->size() < size) return {};
  bytes->resize(static_cast<std::size_t>(size));
  return {*std::move(bytes), true};
}

// Length and data are one stream.
VtuBlock VtuParser::decode_plain(std::string_view data, bool base64) const {
  const VtuBlock head = leading_bytes(data, header_size_, base64);
  if (!head.good) return {};
  const std::uint64_t size = header(head.bytes, 0);
  if (size > data.size()) return {};
  VtuBlock all = leading_bytes(data, header_size_ + size, base64);
  if (all.good) all.bytes.erase(0, header_size_);
  return all;
}

// Header (number of blocks, their size, that of the last, their compressed sizes) and blocks are
// two streams.
VtuBlock VtuParser::decode_compressed(std::string_view data, bool base64) const {
  const VtuBlock start = leading_bytes(data, 3 * header_size_, base64);
  if (!start.good) return {};
  const std::uint64_t blocks = header(start.bytes, 0);
  if (blocks > data.size() / header_size_) return {};
  const std::uint64_t head_size = (3 + blocks) * header_size_;
  const VtuBlock head = leading_bytes(data, head_size, base64);
  if (!head.good) return {};
  data.remove_prefix(static_cast<std::size_t>(base64 ? base64_size(head_size) : head_size));
  std::uint64_t total = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    total += std::min<std::uint64_t>(header(head.bytes, 3 + i), data.size());
    if (total > data.size()) return {};
  }
  const VtuBlock packed = leading_bytes(data, total, base64);
  if (!packed.good) return {};
  VtuBlock result{"", true};
  std::size_t at = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const auto size = static_cast<std::size_t>(header(head.bytes, 3 + i));
    const std::uint64_t last = header(head.bytes, 2);
    const std::uint64_t full = i + 1 == blocks && last != 0 ? last : header(head.bytes, 1);
    if (size > packed.bytes.size() - at) return {};
    const auto bytes =
        inflate(std::string_view(packed.bytes).substr(at, size), static_cast<std::size_t>(full));
    if (!bytes) return {};
    result.bytes += *bytes;
    at += size;
  }
  return result;
}

std::string_view without_white_space_around(std::string_view text) {
  constexpr std::string_view kWhite = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kWhite);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kWhite) - begin + 1);
}

std::string VtuParser::bytes_of(const VtuArray& array) {
  if (ok() && !source_.keep_going(array.line, reader_.line())) error_ = source_.cancelled();
  const bool appended = array.format == "appended";
  if (!appended && array.format != "binary") {
    fail(array.line, concat({"the format ", in_quotes(array.format), " of an array is not known"}));
    return {};
  }
  if (appended && array.offset > appended_.size()) {
    fail(array.line, "an array begins after the end of the appended data");
    return {};
  }
  const std::string_view data = appended ? appended_.substr(static_cast<std::size_t>(array.offset))
                                         : without_white_space_around(array.text);
  const bool base64 = !appended || appended_base64_;
  VtuBlock block = compressed_ ? decode_compressed(data, base64) : decode_plain(data, base64);
  if (!block.good)
    fail(array.line, concat({"the array ", in_quotes(array.name), " cannot be decoded"}));
  return std::move(block.bytes);
}

std::vector<double> VtuParser::ascii_values(const VtuArray& array, std::uint64_t count) {
  Scanner scanner(array.text, source_, {.comment = 0, .across_lines = true});
  std::vector<double> values;
  if (!scanner.has_room_for(count, 1, "values"))
    fail(array.line, concat({"the array ", in_quotes(array.name), " is too short"}));
  while (ok() && scanner.more()) values.push_back(scanner.any_number("value"));
  if (ok() && !scanner.ok() && scanner.error().code == ErrorCode::kCancelled)
    error_ = scanner.error();
  if (!scanner.ok())
    fail(array.line, concat({"the array ", in_quotes(array.name), " holds what is no number"}));
  return values;
}

template <class T>
std::vector<double> numbers_of(std::string_view bytes, std::endian order) {
  std::vector<double> numbers;
  numbers.reserve(bytes.size() / sizeof(T));
  for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T))
    numbers.push_back(static_cast<double>(read_bytes<T>(bytes, at, order)));
  return numbers;
}

std::optional<std::vector<double>> numbers_of_type(std::string_view type, std::string_view bytes,
                                                   std::endian order) {
  if (type == "Float64") return numbers_of<double>(bytes, order);
  if (type == "Float32") return numbers_of<float>(bytes, order);
  if (type == "Int64") return numbers_of<std::int64_t>(bytes, order);
  if (type == "UInt64") return numbers_of<std::uint64_t>(bytes, order);
  if (type == "Int32") return numbers_of<std::int32_t>(bytes, order);
  if (type == "UInt32") return numbers_of<std::uint32_t>(bytes, order);
  if (type == "Int16") return numbers_of<std::int16_t>(bytes, order);
  if (type == "UInt16") return numbers_of<std::uint16_t>(bytes, order);
  if (type == "Int8") return numbers_of<std::int8_t>(bytes, order);
  if (type == "UInt8") return numbers_of<std::uint8_t>(bytes, order);
  return {};
}

// `count` numbers; any count where that is kNoIndex.
std::vector<double> VtuParser::values(const VtuArray& array, std::uint64_t count) {
  std::vector<double> result;
  if (array.format == "ascii") {
    result = ascii_values(array, count == kNoIndex ? 0 : count);
  } else {
    auto numbers = numbers_of_type(array.type, bytes_of(array), order_);
    if (!numbers)
      fail(array.line, concat({"arrays of type ", in_quotes(array.type), " are not known"}));
    if (numbers) result = *std::move(numbers);
  }
  if (ok() && count != kNoIndex && result.size() != count)
    fail(array.line, concat({"the array ", in_quotes(array.name), " holds ", result.size(),
                             " values, not ", count}));
  return result;
}

std::vector<std::int64_t> VtuParser::integers(const VtuArray& array, std::uint64_t count) {
  constexpr double kMost = 9007199254740992.0;  // 2^53
  std::vector<std::int64_t> result;
  for (const double value : values(array, count)) {
    const bool fits = value >= 0 && value <= kMost;
    result.push_back(fits ? static_cast<std::int64_t>(value) : 0);
    if (!fits || static_cast<double>(result.back()) != value)
      fail(array.line, concat({"the array ", in_quotes(array.name), " holds what is no index"}));
  }
  return result;
}

// ---- The grid ------------------------------------------------------------------------------

void VtuParser::add_points(const VtuArray& array, const Piece& piece) {
  const std::vector<double> all = values(array, 3 * piece.points);
  for (std::size_t i = 0; i + 2 < all.size(); i += 3)
    grid_.points.push_back({all[i], all[i + 1], all[i + 2]});
}

void VtuParser::add_cells(const VtuArray& array, const Piece& piece, std::int64_t first_point,
                          std::int64_t first_corner) {
  const bool corners = array.name == "connectivity";
  if (!corners && array.name != "offsets" && array.name != "types") return;
  const auto all = integers(array, corners ? kNoIndex : piece.cells);
  for (const std::int64_t value : all) {
    if (corners) grid_.connectivity.push_back(value + first_point);
    if (array.name == "offsets") grid_.offsets.push_back(value + first_corner);
    if (array.name == "types")
      grid_.types.push_back(value < 256 ? static_cast<std::uint8_t>(value) : std::uint8_t{255});
  }
}

// A field that some piece lacks cannot be joined: geometry_of() would find it too short.
void VtuParser::add_field(const VtuArray& array, std::uint64_t count, std::vector<VtkField>& fields,
                          std::size_t before) {
  if (array.components != 1) return;
  auto found = std::find_if(fields.begin(), fields.end(),
                            [&](const VtkField& field) { return field.name == array.name; });
  if (found == fields.end())
    found = fields.insert(fields.end(), {std::string(array.name), std::vector<double>(before)});
  auto& all = std::get<std::vector<double>>(found->values);
  const std::vector<double> mine = values(array, count);
  all.insert(all.end(), mine.begin(), mine.end());
}

void VtuParser::add_piece(const Piece& piece) {
  const std::size_t points_before = grid_.points.size(), cells_before = grid_.types.size();
  const auto corners_before = static_cast<std::int64_t>(grid_.connectivity.size());
  for (const VtuArray& array : piece.arrays) {
    if (!ok()) return;
    if (array.section == "Points") add_points(array, piece);
    if (array.section == "Cells")
      add_cells(array, piece, static_cast<std::int64_t>(points_before), corners_before);
    if (array.section == "PointData")
      add_field(array, piece.points, grid_.point_fields, points_before);
    if (array.section == "CellData") add_field(array, piece.cells, grid_.cell_fields, cells_before);
  }
  if (ok() && grid_.points.size() != points_before + piece.points)
    fail(1, "the points of a piece are missing");
}

Result<Geometry> VtuParser::parse() {
  read_tags();
  if (!has_root_) fail(1, "the tag VTKFile is missing");
  for (const Piece& piece : pieces_) add_piece(piece);
  if (!ok()) return *error_;
  return geometry_of(grid_, source_.name);
}

}  // namespace

Result<Geometry> parse_vtu(std::string_view bytes, const TextSource& source) {
  return VtuParser(bytes, source).parse();
}

bool recognise_vtu(std::string_view bytes) {
  return bytes.substr(0, 1000).find("<VTKFile") != std::string_view::npos;
}

}  // namespace wellspaced
