#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/io/text/scanner.hpp"

namespace wellspaced {
namespace {

enum class VtkType {
  kInt8,
  kUInt8,
  kInt16,
  kUInt16,
  kInt32,
  kUInt32,
  kInt64,
  kUInt64,
  kFloat,
  kDouble,
  kNone
};

VtkType vtk_type(std::string_view name) {
  using Entry = std::pair<std::string_view, VtkType>;
  constexpr auto kTypes = std::to_array<Entry>({{"char", VtkType::kInt8},
                                                {"unsigned_char", VtkType::kUInt8},
                                                {"short", VtkType::kInt16},
                                                {"unsigned_short", VtkType::kUInt16},
                                                {"int", VtkType::kInt32},
                                                {"unsigned_int", VtkType::kUInt32},
                                                {"long", VtkType::kInt64},
                                                {"unsigned_long", VtkType::kUInt64},
                                                {"vtkIdType", VtkType::kInt32},
                                                {"vtktypeint64", VtkType::kInt64},
                                                {"vtktypeuint64", VtkType::kUInt64},
                                                {"float", VtkType::kFloat},
                                                {"double", VtkType::kDouble}});
  for (const auto& [known, type] : kTypes)
    if (known == name) return type;
  return VtkType::kNone;
}

constexpr std::size_t vtk_size(VtkType type) {
  constexpr std::array<std::size_t, 11> kSizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 1};
  return kSizes[static_cast<std::size_t>(type)];
}

template <class T>
T big_endian(std::string_view raw) {
  return read_bytes<T>(raw, 0, std::endian::big);
}

double decode_vtk(VtkType type, std::string_view raw) {
  switch (type) {
    case VtkType::kInt8:
      return big_endian<std::int8_t>(raw);
    case VtkType::kUInt8:
      return big_endian<std::uint8_t>(raw);
    case VtkType::kInt16:
      return big_endian<std::int16_t>(raw);
    case VtkType::kUInt16:
      return big_endian<std::uint16_t>(raw);
    case VtkType::kInt32:
      return big_endian<std::int32_t>(raw);
    case VtkType::kUInt32:
      return big_endian<std::uint32_t>(raw);
    case VtkType::kInt64:
      return static_cast<double>(big_endian<std::int64_t>(raw));
    case VtkType::kUInt64:
      return static_cast<double>(big_endian<std::uint64_t>(raw));
    case VtkType::kFloat:
      return big_endian<float>(raw);
    case VtkType::kDouble:
      return big_endian<double>(raw);
    case VtkType::kNone:
      break;
  }
  return 0;
}

class VtkParser {
 public:
  VtkParser(std::string_view bytes, const TextSource& source)
      : scanner_(bytes, source, {.comment = 0, .across_lines = true}) {}

  Result<Geometry> parse();

 private:
  void read_header();
  bool read_section();
  bool read_cell_section(std::string_view keyword);
  bool read_data_section(std::string_view keyword);
  void read_points();
  void read_cells(std::uint8_t type);
  void read_old_cells(std::uint64_t count, std::uint64_t size, std::uint8_t type);
  void read_new_cells(std::uint64_t count, std::uint64_t size, std::uint8_t type);
  void read_cell_types();
  void read_scalars();
  void read_field_data();
  void read_array(const std::string& name, std::uint64_t components, std::uint64_t tuples,
                  VtkType type);
  void pass_metadata();
  VtkType read_type();
  std::vector<double> read_values(std::uint64_t count, VtkType type, std::string_view what);
  std::vector<std::int64_t> read_integers(std::uint64_t count, VtkType type, std::string_view what);
  void add_cells(const std::vector<std::int64_t>& corners, std::uint8_t type);

  Scanner scanner_;
  bool binary_ = false;
  VtkGrid grid_;
  std::vector<VtkField>* fields_ = nullptr;  // of points or of cells; null: not wanted
  std::uint64_t tuples_ = 0;
};

void VtkParser::read_header() {
  scanner_.next_line_or_empty();
  const std::string_view banner = scanner_.rest_of_line();
  if (banner.substr(0, 22) != "# vtk DataFile Version")
    scanner_.fail(ErrorCode::kUnreadable, "'# vtk DataFile Version' should stand first");
  scanner_.next_line_or_empty();  // the title
  scanner_.require_line("ASCII or BINARY");
  const std::string_view encoding = scanner_.word("encoding");
  binary_ = encoding == "BINARY";
  if (!binary_ && encoding != "ASCII")
    scanner_.fail(ErrorCode::kUnreadable,
                  {in_quotes(encoding), " where ASCII or BINARY should be"});
  if (scanner_.word("keyword DATASET") != "DATASET")
    scanner_.fail(ErrorCode::kUnreadable, "DATASET is missing");
  const std::string_view kind = scanner_.word("kind of data set");
  if (kind != "UNSTRUCTURED_GRID" && kind != "POLYDATA")
    scanner_.fail(ErrorCode::kUnreadable,
                  {"data sets of kind ", in_quotes(kind),
                   " are not understood, only UNSTRUCTURED_GRID and POLYDATA"});
}

VtkType VtkParser::read_type() {
  const std::string_view name = scanner_.word("type of numbers");
  const VtkType type = vtk_type(name);
  if (type == VtkType::kNone)
    scanner_.fail(ErrorCode::kUnreadable, {"numbers of type ", in_quotes(name), " are not known"});
  return type;
}

std::vector<double> VtkParser::read_values(std::uint64_t count, VtkType type,
                                           std::string_view what) {
  std::vector<double> values;
  if (!binary_) {
    if (!scanner_.has_room_for(count, 1, what)) return {};
    for (std::uint64_t i = 0; i < count && scanner_.ok(); ++i)
      values.push_back(scanner_.any_number(what));
    return values;
  }
  const std::size_t size = vtk_size(type);
  if (count > std::uint64_t{1} << 60)
    scanner_.fail(ErrorCode::kUnreadable, "a number of values that makes no sense");
  const std::string_view raw = scanner_.ok() ? scanner_.bytes_after_line(count * size, what) : "";
  values.reserve(raw.size() / size);
  for (std::size_t at = 0; at < raw.size(); at += size)
    values.push_back(decode_vtk(type, raw.substr(at, size)));
  return values;
}

std::vector<std::int64_t> VtkParser::read_integers(std::uint64_t count, VtkType type,
                                                   std::string_view what) {
  constexpr double kMost = 9007199254740992.0;  // 2^53
  std::vector<std::int64_t> integers;
  for (const double value : read_values(count, type, what)) {
    const bool fits = value >= -kMost && value <= kMost;
    integers.push_back(fits ? static_cast<std::int64_t>(value) : -1);
    if (!fits || static_cast<double>(integers.back()) != value)
      scanner_.fail(ErrorCode::kUnreadable, {"one of the ", what, " is no integer"});
  }
  return integers;
}

void VtkParser::read_points() {
  const Index count = scanner_.count("points", 1);
  const VtkType type = read_type();
  const std::vector<double> values = read_values(std::uint64_t{count} * 3, type, "coordinates");
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    grid_.points.push_back({values[i], values[i + 1], values[i + 2]});
}

void VtkParser::add_cells(const std::vector<std::int64_t>& corners, std::uint8_t type) {
  grid_.connectivity.insert(grid_.connectivity.end(), corners.begin(), corners.end());
  grid_.offsets.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
  if (type != kVtkEmpty) grid_.types.push_back(type);
}

// Each cell: how many corners, then the corners.
void VtkParser::read_old_cells(std::uint64_t count, std::uint64_t size, std::uint8_t type) {
  const auto values = read_integers(size, VtkType::kInt32, "corners of cells");
  std::size_t at = 0;
  for (std::uint64_t cell = 0; cell < count && scanner_.ok(); ++cell) {
    const std::int64_t corners = at < values.size() ? values[at] : -1;
    if (corners < 0 || static_cast<std::uint64_t>(corners) > values.size() - at - 1)
      return scanner_.fail(ErrorCode::kUnreadable,
                           {"cell ", cell, " (counted from 0) is incomplete"});
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    add_cells({begin, begin + corners}, type);
    at += static_cast<std::size_t>(corners) + 1;
  }
  if (at != values.size())
    scanner_.fail(ErrorCode::kUnreadable, "the cells do not fill their announced size");
}

// Since VTK 9: one offset more than there are cells, then all corners.
void VtkParser::read_new_cells(std::uint64_t count, std::uint64_t size, std::uint8_t type) {
  scanner_.word("keyword OFFSETS");
  const VtkType offset_type = read_type();
  const auto offsets = read_integers(count, offset_type, "offsets of cells");
  if (scanner_.word("keyword CONNECTIVITY") != "CONNECTIVITY")
    scanner_.fail(ErrorCode::kUnreadable, "CONNECTIVITY is missing");
  const VtkType corner_type = read_type();
  const auto corners = read_integers(size, corner_type, "corners of cells");
  if (!scanner_.ok()) return;
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    const std::int64_t begin = offsets[i - 1], end = offsets[i];
    if (begin < 0 || end < begin || end > static_cast<std::int64_t>(corners.size()))
      return scanner_.fail(ErrorCode::kUnreadable, "the offsets of cells make no sense");
    add_cells({corners.begin() + begin, corners.begin() + end}, type);
  }
}

// `type` is that of all cells, or kVtkEmpty where CELL_TYPES will tell.
void VtkParser::read_cells(std::uint8_t type) {
  const Index count = scanner_.count("cells", 0);
  const Index size = scanner_.count("corners of cells", 0);
  if (!scanner_.ok() || (count == 0 && size == 0)) return;
  Scanner ahead = scanner_;
  if (ahead.next_line() && ahead.word("cells") == "OFFSETS") {
    read_new_cells(count, size, type);
  } else {
    read_old_cells(count, size, type);
  }
}

void VtkParser::read_cell_types() {
  const Index count = scanner_.count("cells", 0);
  const auto types = read_integers(count, VtkType::kInt32, "types of cells");
  for (const std::int64_t type : types)
    grid_.types.push_back(type >= 0 && type < 256 ? static_cast<std::uint8_t>(type) : 255);
}

void VtkParser::read_array(const std::string& name, std::uint64_t components, std::uint64_t tuples,
                           VtkType type) {
  if (components > 1000 || tuples >= kNoIndex)
    return scanner_.fail(ErrorCode::kUnreadable, "the size of a field makes no sense");
  std::vector<double> values = read_values(components * tuples, type, "values of a field");
  if (fields_ != nullptr && components == 1 && tuples == tuples_)
    fields_->push_back({name, std::move(values)});
}

void VtkParser::read_scalars() {
  const std::string name(scanner_.word("name of a field"));
  const VtkType type = read_type();
  const std::int64_t components = scanner_.more_on_line() ? scanner_.integer("components") : 1;
  Scanner table = scanner_;
  if (table.more() && table.word("keyword") == "LOOKUP_TABLE") {
    table.word("name of a table");
    scanner_ = table;
  }
  if (components < 1) scanner_.fail(ErrorCode::kUnreadable, "a field without components");
  read_array(name, static_cast<std::uint64_t>(components), tuples_, type);
}

void VtkParser::read_field_data() {
  scanner_.word("name of the field data");
  const Index arrays = scanner_.count("fields", 4);
  for (Index i = 0; i < arrays && scanner_.ok(); ++i) {
    const std::string name(scanner_.word("name of a field"));
    if (name == "METADATA") {
      pass_metadata();
      --i;
      continue;
    }
    const Index components = scanner_.count("components", 0);
    const Index tuples = scanner_.count("tuples", 0);
    read_array(name, components, tuples, read_type());
  }
}

// Up to the next empty line.
void VtkParser::pass_metadata() {
  while (scanner_.next_line_or_empty())
    if (!scanner_.more_on_line()) return;
}

bool VtkParser::read_cell_section(std::string_view keyword) {
  if (keyword == "CELLS") return read_cells(kVtkEmpty), true;
  if (keyword == "CELL_TYPES") return read_cell_types(), true;
  if (keyword == "VERTICES") return read_cells(kVtkPolyVertex), true;
  if (keyword == "LINES") return read_cells(kVtkPolyLine), true;
  if (keyword == "POLYGONS") return read_cells(kVtkPolygon), true;
  return false;
}

bool VtkParser::read_data_section(std::string_view keyword) {
  if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
    tuples_ = scanner_.count("values", 0);
    const bool points = keyword == "POINT_DATA";
    fields_ = points ? &grid_.point_fields : &grid_.cell_fields;
    if (tuples_ != (points ? grid_.points.size() : grid_.types.size()))
      scanner_.fail(ErrorCode::kUnreadable, "the data are not as many as the points or cells");
  } else if (keyword == "SCALARS") {
    read_scalars();
  } else if (keyword == "VECTORS" || keyword == "NORMALS" || keyword == "TENSORS") {
    const std::string name(scanner_.word("name of a field"));
    read_array(name, keyword == "TENSORS" ? 9 : 3, tuples_, read_type());
  } else if (keyword == "FIELD") {
    read_field_data();
  } else if (keyword == "METADATA") {
    pass_metadata();
  } else {
    return false;
  }
  return true;
}

bool VtkParser::read_section() {
  if (!scanner_.ok() || !scanner_.more()) return false;
  const std::string keyword(scanner_.word("keyword"));
  if (keyword == "POINTS") {
    read_points();
  } else if (!read_cell_section(keyword) && !read_data_section(keyword)) {
    scanner_.fail(ErrorCode::kUnreadable, {"the section ", in_quotes(keyword), " is not known"});
  }
  return scanner_.ok();
}

Result<Geometry> VtkParser::parse() {
  read_header();
  while (read_section()) {
  }
  if (!scanner_.ok()) return scanner_.error();
  return geometry_of(grid_, scanner_.file());
}

}  // namespace

Result<Geometry> parse_vtk(std::string_view bytes, const TextSource& source) {
  return VtkParser(bytes, source).parse();
}

bool recognise_vtk(std::string_view bytes) { return bytes.substr(0, 14) == "# vtk DataFile"; }

}  // namespace wellspaced
