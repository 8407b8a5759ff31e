#include <concepts>
#include <functional>

#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/text/base64.hpp"
#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/io/text/markup.hpp"

namespace wellspaced {
namespace {

template <class T>
constexpr std::string_view type_name() {
  if constexpr (std::same_as<T, double>) return "Float64";
  if constexpr (std::same_as<T, std::int64_t>) return "Int64";
  if constexpr (std::same_as<T, std::int32_t>) return "Int32";
  return "UInt8";
}

// Writes the arrays of one file; appended ones wait for the end.
class VtuWriter {
 public:
  VtuWriter(TextWriter& out, VtuEncoding encoding) : out_(out), encoding_(encoding) {}

  void write(const VtkGrid& grid);

 private:
  template <class T>
  void write_array(std::string_view name, std::size_t components, const std::vector<T>& values);
  template <class T>
  void write_ascii(const std::vector<T>& values);
  template <class T>
  void write_bytes(const std::vector<T>& values);
  void pass_on(std::string_view bytes);
  void write_fields(std::string_view element, const std::vector<VtkField>& fields);

  TextWriter& out_;
  VtuEncoding encoding_;
  std::uint64_t appended_size_ = 0;
  std::vector<std::function<void()>> appended_;
};

// Their size, then the values, in pieces: of whole groups of three bytes, which base64 does not
// pad.
template <class T>
void VtuWriter::write_bytes(const std::vector<T>& values) {
  constexpr std::size_t kPiece = 3 << 14;
  std::string bytes;
  append_bytes(bytes, std::uint64_t{values.size() * sizeof(T)});
  for (const T value : values) {
    append_bytes(bytes, value);
    if (bytes.size() < kPiece) continue;
    pass_on(std::string_view(bytes).substr(0, kPiece));
    bytes.erase(0, kPiece);
    if (out_.failed()) return;
  }
  pass_on(bytes);
}

void VtuWriter::pass_on(std::string_view bytes) {
  encoding_ == VtuEncoding::kBase64 ? out_ << base64(bytes) : out_ << bytes;
}

template <class T>
void VtuWriter::write_ascii(const std::vector<T>& values) {
  constexpr std::size_t kPerLine = 12;
  for (std::size_t i = 0; i < values.size(); ++i)
    out_ << values[i] << (i % kPerLine == kPerLine - 1 ? '\n' : ' ');
}

template <class T>
void VtuWriter::write_array(std::string_view name, std::size_t components,
                            const std::vector<T>& values) {
  out_ << "<DataArray type=\"" << type_name<T>() << "\" Name=\"" << escape_markup(name) << '"';
  if (components > 1) out_ << " NumberOfComponents=\"" << components << '"';
  switch (encoding_) {
    case VtuEncoding::kAscii:
      out_ << " format=\"ascii\">\n";
      write_ascii(values);
      out_ << "\n</DataArray>\n";
      break;
    case VtuEncoding::kBase64:
      out_ << " format=\"binary\">\n";
      write_bytes(values);
      out_ << "\n</DataArray>\n";
      break;
    case VtuEncoding::kRaw:
      out_ << " format=\"appended\" offset=\"" << appended_size_ << "\"/>\n";
      appended_size_ += 8 + values.size() * sizeof(T);
      appended_.push_back([this, &values] { write_bytes(values); });
      break;
  }
}

void VtuWriter::write_fields(std::string_view element, const std::vector<VtkField>& fields) {
  out_ << '<' << element << ">\n";
  for (const VtkField& field : fields)
    std::visit([&](const auto& values) { write_array(field.name, 1, values); }, field.values);
  out_ << "</" << element << ">\n";
}

std::vector<double> coordinates(const std::vector<Point3>& points) {
  std::vector<double> result;
  result.reserve(3 * points.size());
  for (const Point3& p : points) result.insert(result.end(), {p.x, p.y, p.z});
  return result;
}

void VtuWriter::write(const VtkGrid& grid) {
  const std::vector<double> points = coordinates(grid.points);
  out_ << "<?xml version=\"1.0\"?>\n";
  if (!grid.remark.empty()) out_ << "<!-- " << grid.remark << " -->\n";
  out_ << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
       << grid.points.size() << "\" NumberOfCells=\"" << grid.types.size() << "\">\n<Points>\n";
  write_array("Points", 3, points);
  out_ << "</Points>\n<Cells>\n";
  write_array("connectivity", 1, grid.connectivity);
  write_array("offsets", 1, grid.offsets);
  write_array("types", 1, grid.types);
  out_ << "</Cells>\n";
  write_fields("PointData", grid.point_fields);
  write_fields("CellData", grid.cell_fields);
  out_ << "</Piece>\n</UnstructuredGrid>\n";
  if (encoding_ == VtuEncoding::kRaw) {
    out_ << "<AppendedData encoding=\"raw\">\n_";
    for (const auto& write_array_bytes : appended_) write_array_bytes();
    out_ << "\n</AppendedData>\n";
  }
  out_ << "</VTKFile>\n";
}

}  // namespace

void write_vtu(TextWriter& out, const VtkGrid& grid, VtuEncoding encoding) {
  VtuWriter(out, encoding).write(grid);
}

}  // namespace wellspaced
