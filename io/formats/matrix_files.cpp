#include "wellspaced/io/formats/matrix_files.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "wellspaced/io/text/bytes.hpp"
#include "wellspaced/kernel/concat.hpp"

namespace wellspaced {
namespace {

// ---- MatrixMarket

std::string matrix_market_bytes(const SparseMatrix& matrix) {
  TextWriter out;
  out << "%%MatrixMarket matrix coordinate real general\n";
  out << matrix.rows() << ' ' << matrix.columns << ' ' << matrix.entries() << '\n';
  for (Index i = 0; i < matrix.rows(); ++i)
    for (std::size_t k = matrix.first[i]; k < matrix.first[i + 1]; ++k)
      out << i + 1 << ' ' << matrix.column[k] + 1 << ' ' << matrix.value[k] << '\n';
  return out.text();
}

// ---- PETSc

std::string petsc_bytes(const SparseMatrix& matrix) {
  constexpr std::int32_t kMatrixClass = 1211216;
  std::string bytes;
  const auto add = [&](auto value) { append_bytes(bytes, value, std::endian::big); };
  const auto add_integer = [&](std::size_t value) { add(static_cast<std::int32_t>(value)); };
  add(kMatrixClass);
  add_integer(matrix.rows());
  add_integer(matrix.columns);
  add_integer(matrix.entries());
  for (Index i = 0; i < matrix.rows(); ++i) add_integer(matrix.row(i).size());
  for (const Index j : matrix.column) add_integer(j);
  for (const double value : matrix.value) add(value);
  return bytes;
}

// ---- NumPy arrays in a zip archive

std::string npy_bytes(std::string_view type, std::string_view shape, const std::string& data) {
  std::string header = "{'descr': '";
  header.append(type).append("', 'fortran_order': False, 'shape': ").append(shape).append(", }");
  constexpr std::size_t kPreamble = 10, kAlignment = 64;
  while ((kPreamble + header.size() + 1) % kAlignment != 0) header += ' ';
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes.append({'\1', '\0'});
  append_bytes(bytes, static_cast<std::uint16_t>(header.size()));
  return concat({bytes, header, data});
}

std::string vector_shape(std::size_t size) {
  return std::string("(").append(std::to_string(size)).append(",)");
}

template <class Target, class Source>
std::string raw_bytes(const std::vector<Source>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(Target));
  for (const Source value : values) append_bytes(bytes, static_cast<Target>(value));
  return bytes;
}

std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    table[byte] = byte;
    for (int bit = 0; bit < 8; ++bit)
      table[byte] = (table[byte] >> 1) ^ (table[byte] & 1 ? 0xEDB88320u : 0u);
  }
  return table;
}

std::uint32_t crc32(std::string_view bytes) {
  const auto table = crc_table();
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : bytes) crc = (crc >> 8) ^ table[(crc ^ static_cast<unsigned char>(c)) & 255];
  return ~crc;
}

// An archive of stored files, all of the first of January 1980.
class ZipArchive {
 public:
  void add(std::string_view name, const std::string& data) {
    const auto offset = static_cast<std::uint32_t>(bytes_.size());
    std::string description;  // what both headers of a file hold
    const auto describe = [&](auto value) { append_bytes(description, value); };
    describe(std::uint16_t{20});  // version needed
    describe(std::uint16_t{0});   // flags
    describe(std::uint16_t{0});   // stored
    describe(std::uint16_t{0});   // time
    describe(std::uint16_t{33});  // date
    describe(crc32(data));
    describe(static_cast<std::uint32_t>(data.size()));
    describe(static_cast<std::uint32_t>(data.size()));
    describe(static_cast<std::uint16_t>(name.size()));
    describe(std::uint16_t{0});  // extra field

    bytes_.append("PK\3\4").append(description).append(name).append(data);
    directory_.append("PK\1\2");
    append_bytes(directory_, std::uint16_t{20});  // version made by
    directory_.append(description);
    directory_.append(10, '\0');  // no comment, disk 0, no attributes
    append_bytes(directory_, offset);
    directory_.append(name);
    ++files_;
  }

  std::string finish() && {
    const auto directory_offset = static_cast<std::uint32_t>(bytes_.size());
    bytes_.append(directory_).append("PK\5\6").append(4, '\0');
    append_bytes(bytes_, files_);
    append_bytes(bytes_, files_);
    append_bytes(bytes_, static_cast<std::uint32_t>(directory_.size()));
    append_bytes(bytes_, directory_offset);
    append_bytes(bytes_, std::uint16_t{0});  // no comment
    return std::move(bytes_);
  }

 private:
  std::string bytes_, directory_;
  std::uint16_t files_ = 0;
};

std::string npz_bytes(const SparseMatrix& matrix) {
  const std::vector<std::int64_t> shape = {matrix.rows(), matrix.columns};
  ZipArchive archive;
  archive.add("indices.npy", npy_bytes("<i4", vector_shape(matrix.entries()),
                                       raw_bytes<std::int32_t>(matrix.column)));
  archive.add("indptr.npy", npy_bytes("<i4", vector_shape(matrix.first.size()),
                                      raw_bytes<std::int32_t>(matrix.first)));
  archive.add("format.npy", npy_bytes("|S3", "()", "csr"));
  archive.add("shape.npy", npy_bytes("<i8", "(2,)", raw_bytes<std::int64_t>(shape)));
  archive.add("data.npy",
              npy_bytes("<f8", vector_shape(matrix.entries()), raw_bytes<double>(matrix.value)));
  return std::move(archive).finish();
}

constexpr std::array kMatrixFormats = {
    MatrixFormat{"mtx", ".mtx", "MatrixMarket text", matrix_market_bytes},
    MatrixFormat{"petsc", ".petsc", "PETSc binary", petsc_bytes},
    MatrixFormat{"npz", ".npz", "SciPy's CSR in NumPy's archive", npz_bytes}};

}  // namespace

std::span<const MatrixFormat> matrix_formats() { return kMatrixFormats; }

const MatrixFormat* find_matrix_format(std::string_view name) {
  const auto found = std::ranges::find(kMatrixFormats, name, &MatrixFormat::name);
  return found == kMatrixFormats.end() ? nullptr : &*found;
}

Status write_matrix(OutputSet& outputs, const std::string& path, const MatrixFormat& format,
                    const SparseMatrix& matrix) {
  constexpr std::size_t kTooManyEntries = std::size_t{1} << 28, kTooLong = std::size_t{1} << 31;
  if (matrix.entries() >= kTooManyEntries || matrix.rows() >= kTooLong ||
      matrix.columns >= kTooLong)
    return Error{ErrorCode::kLimit, {path, ": the matrix is too large for the format"}};
  return outputs.add(path, [&](TextWriter& out) { out << format.bytes(matrix); });
}

}  // namespace wellspaced
