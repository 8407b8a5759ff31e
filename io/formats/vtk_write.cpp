#include <bit>

#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/text/bytes.hpp"

namespace wellspaced {
namespace {

// Writes the numbers of a legacy file: text, or big-endian bytes.
class VtkWriter {
 public:
  VtkWriter(TextWriter& out, VtkEncoding encoding) : out_(out), encoding_(encoding) {}

  void write(const VtkGrid& grid);

 private:
  template <class T>
  void number(T value) {
    if (encoding_ == VtkEncoding::kAscii) {
      out_ << value << ' ';
    } else {
      bytes_.clear();
      append_bytes(bytes_, value, std::endian::big);
      out_ << bytes_;
    }
  }
  void end_of_line() {
    if (encoding_ == VtkEncoding::kAscii) out_ << '\n';
  }
  void write_cells(const VtkGrid& grid);
  void write_fields(const char* section, std::size_t count, const std::vector<VtkField>& fields);

  TextWriter& out_;
  VtkEncoding encoding_;
  std::string bytes_;
};

std::string without_blanks(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  return name;
}

void VtkWriter::write_cells(const VtkGrid& grid) {
  const std::size_t cells = grid.types.size();
  out_ << "CELLS " << cells << ' ' << cells + grid.connectivity.size() << '\n';
  std::int64_t begin = 0;
  for (const std::int64_t end : grid.offsets) {
    number(static_cast<std::int32_t>(end - begin));
    for (; begin < end; ++begin)
      number(static_cast<std::int32_t>(grid.connectivity[static_cast<std::size_t>(begin)]));
    end_of_line();
  }
  out_ << "\nCELL_TYPES " << cells << '\n';
  for (const std::uint8_t type : grid.types) {
    number(static_cast<std::int32_t>(type));
    end_of_line();
  }
}

void VtkWriter::write_fields(const char* section, std::size_t count,
                             const std::vector<VtkField>& fields) {
  if (fields.empty()) return;
  out_ << '\n' << section << ' ' << count << '\n';
  for (const VtkField& field : fields) {
    const bool real = std::holds_alternative<std::vector<double>>(field.values);
    out_ << "SCALARS " << without_blanks(field.name) << (real ? " double" : " int")
         << " 1\nLOOKUP_TABLE default\n";
    const auto write_values = [&](const auto& values) {
      for (const auto value : values) {
        number(value);
        end_of_line();
      }
    };
    std::visit(write_values, field.values);
    out_ << '\n';
  }
}

void VtkWriter::write(const VtkGrid& grid) {
  out_ << "# vtk DataFile Version 3.0\n"
       << (grid.remark.empty() ? "wellspaced" : grid.remark) << '\n'
       << (encoding_ == VtkEncoding::kAscii ? "ASCII" : "BINARY")
       << "\nDATASET UNSTRUCTURED_GRID\nPOINTS " << grid.points.size() << " double\n";
  for (const Point3& p : grid.points) {
    for (const double coordinate : {p.x, p.y, p.z}) number(coordinate);
    end_of_line();
  }
  out_ << '\n';
  write_cells(grid);
  write_fields("POINT_DATA", grid.points.size(), grid.point_fields);
  write_fields("CELL_DATA", grid.types.size(), grid.cell_fields);
}

}  // namespace

void write_vtk(TextWriter& out, const VtkGrid& grid, VtkEncoding encoding) {
  VtkWriter(out, encoding).write(grid);
}

}  // namespace wellspaced
