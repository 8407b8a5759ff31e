#include "wellspaced/io/formats/formats.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "wellspaced/io/files/input_file.hpp"
#include "wellspaced/io/formats/gmsh.hpp"
#include "wellspaced/io/formats/medit.hpp"
#include "wellspaced/io/formats/metis.hpp"
#include "wellspaced/io/formats/point_files.hpp"
#include "wellspaced/io/formats/solver_files.hpp"
#include "wellspaced/io/formats/surface_files.hpp"
#include "wellspaced/io/formats/triangle_files.hpp"
#include "wellspaced/io/formats/triangle_text.hpp"
#include "wellspaced/io/formats/vtk.hpp"
#include "wellspaced/io/pictures/cut_away.hpp"
#include "wellspaced/io/pictures/svg.hpp"
#include "wellspaced/io/text/scanner.hpp"
#include "wellspaced/kernel/concat.hpp"
#include "wellspaced/kernel/quantifiers.hpp"

namespace wellspaced {
namespace {

Error wrong_usage(std::string message) { return {ErrorCode::kUsage, std::move(message)}; }

// A header "count dimension attributes markers", and how many lines of fields follow it.
bool has_node_header(std::string_view text) {
  Scanner scanner(text, "");
  if (!scanner.next_line() || scanner.count_fields() != 4) return false;
  scanner.integer("count");
  const std::int64_t dimension = scanner.integer("dimension");
  return scanner.ok() && (dimension == 2 || dimension == 3);
}

std::uint64_t count_lines(std::string_view text) {
  Scanner scanner(text, "");
  std::uint64_t lines = 0;
  while (scanner.next_line()) ++lines;
  return lines;
}

std::uint64_t announced_points(std::string_view text) {
  Scanner scanner(text, "");
  scanner.next_line();
  return static_cast<std::uint64_t>(scanner.integer("count"));
}

bool recognise_node(std::string_view text) {
  return has_node_header(text) && count_lines(text) <= announced_points(text) + 1;
}

bool recognise_poly(std::string_view text) { return has_node_header(text); }

bool recognise_xyz(std::string_view text) {
  Scanner scanner(text, "");
  if (!scanner.next_line()) return true;
  const std::size_t fields = scanner.count_fields();
  return fields == 2 || fields == 3;
}

Result<Geometry> parse_poly_alone(std::string_view text, const TextSource& source) {
  return parse_poly(text, source);
}

Result<Geometry> parse_smesh_alone(std::string_view text, const TextSource& source) {
  return parse_smesh(text, source);
}

template <void (*kWrite)(TextWriter&, const Geometry&)>
Status write_one(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  return outputs.add(path, [&](TextWriter& out) { kWrite(out, geometry); });
}

// A domain goes into one file; the .poly of a mesh has its .node beside it.
Status write_poly_or_set(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (geometry.has_cells()) return write_triangle_set(outputs, path, geometry);
  return write_poly_file(outputs, path, geometry);
}

Status write_set(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (path == "-") return write_one<write_node>(outputs, path, geometry);
  return write_triangle_set(outputs, path, geometry);
}

// Numbers every column of attributes: "attribute0", ... Segments, which come after the cells in
// the grid, have none: 0.
void add_attributes(std::vector<VtkField>& fields, const Attributes& attributes,
                    std::size_t values) {
  for (Index column = 0; column < attributes.columns; ++column) {
    std::vector<double> field;
    for (std::size_t i = column; i < attributes.values.size(); i += attributes.columns)
      field.push_back(attributes.values[i]);
    field.resize(values);
    fields.push_back({concat({"attribute", column}), std::move(field)});
  }
}

VtkGrid grid_of(const Geometry& geometry) {
  VtkGrid grid = geometry.dimension == 2 ? vtk_grid(geometry.mesh) : vtk_grid(geometry.solid);
  add_attributes(grid.point_fields, geometry.point_attributes, grid.points.size());
  add_attributes(grid.cell_fields, geometry.cell_attributes, grid.types.size());
  grid.remark = geometry.remark;
  return grid;
}

template <VtuEncoding kEncoding>
Status write_as_vtu(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (Status status = refuse_polygons(geometry, path, "a VTU file"); !status) return status;
  return outputs.add(path, [&](TextWriter& out) { write_vtu(out, grid_of(geometry), kEncoding); });
}

template <VtkEncoding kEncoding>
Status write_as_vtk(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  constexpr std::size_t kMostPoints = 0x7FFFFFFF;  // legacy files count with 32 bits
  if (geometry.point_count() > kMostPoints)
    return wrong_usage(
        concat({path, ": a legacy VTK file holds 2147483647 points at most; write .vtu"}));
  if (Status status = refuse_polygons(geometry, path, "a VTK file"); !status) return status;
  const VtkGrid grid = grid_of(geometry);
  return outputs.add(path, [&](TextWriter& out) { write_vtk(out, grid, kEncoding); });
}

Status write_as_svg(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  if (geometry.dimension == 3 && geometry.solid.tets.empty())
    return wrong_usage(concat({path, ": of what is in space only tetrahedra can be drawn"}));
  return outputs.add(path, [&](TextWriter& out) {
    if (geometry.dimension == 3) return write_cut_away_svg(out, geometry.solid);
    write_mesh_svg(out, geometry.mesh);
  });
}

template <GmshVersion kVersion, GmshEncoding kEncoding>
Status write_as_gmsh(OutputSet& outputs, const std::string& path, const Geometry& geometry) {
  return write_gmsh(outputs, path, geometry, {kVersion, kEncoding});
}

using Part = GeometryPart;
constexpr unsigned kEverything = ~0U;
constexpr unsigned kSurface = Part::kCells | Part::kFacets;
constexpr unsigned kEdges = Part::kSegments | Part::kSegmentsInSpace;
constexpr unsigned kMarkedElements = kSurface | kEdges | Part::kSegmentMarkers |
                                     Part::kFacetMarkers | Part::kCellMarkers |
                                     Part::kMarkersBelowOne;
constexpr unsigned kKeptByMedit = kMarkedElements | Part::kPointMarkers;
constexpr unsigned kKeptByGmsh = kKeptByMedit | Part::kMarkerNames;
constexpr unsigned kKeptByVtk = kKeptByMedit | Part::kPointAttributes | Part::kCellAttributes;
constexpr unsigned kKeptByTriangle = kEverything & ~Part::kMarkerNames;
constexpr unsigned kKeptByObj = kMarkedElements;
constexpr unsigned kKeptByMfem =
    kMarkedElements & ~(Part::kSegmentsInSpace | Part::kMarkersBelowOne);
constexpr unsigned kKeptBySu2 =
    (kMarkedElements & ~(Part::kSegmentsInSpace | Part::kCellMarkers)) | Part::kMarkerNames;
constexpr unsigned kKeptBySmesh = Part::kPointAttributes | Part::kPointMarkers | Part::kFacets |
                                  Part::kFacetMarkers | Part::kMarkersBelowOne |
                                  Part::kHolesAndRegions;

// In the order in which contents are tried: first those that announce themselves. To add a format,
// add a line. Those without an extension are other ways to write one.
constexpr auto kFormats = std::to_array<Format>({
    {"gmsh", ".msh", "Gmsh 4.1, plain text", kKeptByGmsh, parse_gmsh, recognise_gmsh,
     write_as_gmsh<GmshVersion::k41, GmshEncoding::kAscii>},
    {"gmsh22", "", "Gmsh 2.2, plain text", kKeptByGmsh, parse_gmsh, nullptr,
     write_as_gmsh<GmshVersion::k22, GmshEncoding::kAscii>},
    {"gmsh-binary", "", "Gmsh 4.1, binary", kKeptByGmsh, parse_gmsh, nullptr,
     write_as_gmsh<GmshVersion::k41, GmshEncoding::kBinary>},
    {"gmsh22-binary", "", "Gmsh 2.2, binary", kKeptByGmsh, parse_gmsh, nullptr,
     write_as_gmsh<GmshVersion::k22, GmshEncoding::kBinary>},
    {"vtu", ".vtu", "VTK XML, base64", kKeptByVtk, parse_vtu, recognise_vtu,
     write_as_vtu<VtuEncoding::kBase64>},
    {"vtu-ascii", "", "VTK XML, plain text", kKeptByVtk, parse_vtu, nullptr,
     write_as_vtu<VtuEncoding::kAscii>},
    {"vtu-raw", "", "VTK XML, raw binary", kKeptByVtk, parse_vtu, nullptr,
     write_as_vtu<VtuEncoding::kRaw>},
    {"vtk", ".vtk", "legacy VTK, plain text", kKeptByVtk, parse_vtk, recognise_vtk,
     write_as_vtk<VtkEncoding::kAscii>},
    {"vtk-binary", "", "legacy VTK, binary", kKeptByVtk, parse_vtk, nullptr,
     write_as_vtk<VtkEncoding::kBinary>},
    {"medit", ".mesh", "Medit: mmg, FreeFEM", kKeptByMedit, parse_medit, recognise_medit,
     write_medit},
    {"mfem", ".mfem .mesh", "MFEM mesh v1.0", kKeptByMfem, parse_mfem, recognise_mfem, write_mfem},
    {"su2", ".su2", "SU2", kKeptBySu2, parse_su2, recognise_su2, write_su2},
    {"off", ".off", "Object File Format: a surface", kSurface, parse_off, recognise_off, write_off},
    {"stl", ".stl", "STL: triangles, plain text", kSurface, parse_stl, recognise_stl, write_stl},
    {"stl-binary", "", "STL: triangles, 32-bit binary", kSurface, parse_stl, nullptr,
     write_stl_binary},
    {"obj", ".obj", "Wavefront OBJ: a surface", kKeptByObj, parse_obj, recognise_obj, write_obj},
    {"triangle", ".node .ele .edge .face", "Triangle's and TetGen's .node, .ele, .poly, ...",
     kKeptByTriangle, parse_node, recognise_node, write_set},
    {"poly", ".poly", "Triangle's and TetGen's domains", kKeptByTriangle, parse_poly_alone,
     recognise_poly, write_poly_or_set},
    {"smesh", ".smesh", "TetGen's simpler domains in space", kKeptBySmesh, parse_smesh_alone,
     nullptr, write_smesh_file},
    {"fort14", ".14 .grd", "ADCIRC's fort.14", 0, parse_fort14, recognise_fort14, nullptr},
    {"f64", ".f64", "points as little-endian doubles", 0, parse_f64, looks_like_f64,
     write_one<write_f64>},
    {"xyz", ".xyz", "points, one a line", 0, parse_xyz, recognise_xyz, write_one<write_xyz>},
    {"metis", ".graph", "METIS .graph and coordinates in .xyz", kEdges, nullptr, nullptr,
     write_metis, read_metis},
    {"svg", ".svg", "a picture; tetrahedra cut open", kEverything, nullptr, nullptr, write_as_svg},
});

bool has_word(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != std::string_view::npos;
       at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

const Format* find_by_name(std::string_view name) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const Format& format) { return format.name == name; });
  return found == kFormats.end() ? nullptr : &*found;
}

// ".obj" for "dir/X.OBJ"; empty if there is none, as in "dir/.X".
std::string lower_extension_of(const std::string& path) {
  const std::size_t name = path.find_last_of('/') + 1;
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string::npos || dot <= name) return {};
  std::string extension = path.substr(dot);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

const Format* find_by_extension(const std::string& path) {
  const std::string extension = lower_extension_of(path);
  if (extension.empty()) return nullptr;
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& format) {
    return has_word(format.extensions, extension);
  });
  return found == kFormats.end() ? nullptr : &*found;
}

// Several formats may have the same extension: then the content decides.
const Format* find_by_extension(const std::string& path, std::string_view text) {
  const std::string extension = lower_extension_of(path);
  if (extension.empty()) return nullptr;
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& format) {
    return has_word(format.extensions, extension) && format.recognise != nullptr &&
           format.recognise(text);
  });
  return found == kFormats.end() ? find_by_extension(path) : &*found;
}

const Format* find_by_content(std::string_view text) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& format) {
    return format.recognise != nullptr && format.recognise(text);
  });
  return found == kFormats.end() ? nullptr : &*found;
}

// What is to be written to `path`, where a name of a format overrules its extension: Triangle's
// files where neither says anything.
const Format* find_output_format(const std::string& path, const std::string& format_name) {
  if (format_name.empty() && path != "-" && lower_extension_of(path).empty())
    return find_by_name("triangle");
  return format_name.empty() ? find_by_extension(path) : find_by_name(format_name);
}

// Whether some markers are positive and others are not.
bool mixes_markers(const std::vector<int>& markers) {
  const auto is_positive = [](int marker) { return marker > 0; };
  return any_of(markers, is_positive) ? !all_of(markers, is_positive)
                                      : any_of(markers, [](int marker) { return marker < 0; });
}

std::string names_of(bool (*wanted)(const Format&)) {
  std::string names;
  for (const Format& format : kFormats)
    if (wanted(format)) append(names, {names.empty() ? "" : ", ", format.name});
  return names;
}

std::string readable_names() {
  return names_of([](const Format& format) { return format.readable(); });
}

std::string writable_names() {
  return names_of([](const Format& format) { return format.write != nullptr; });
}

const Format* find_format(const std::string& name, const std::string& path, std::string_view text) {
  if (!name.empty()) return find_by_name(name);
  const Format* const format = find_by_extension(path, text);
  return format != nullptr ? format : find_by_content(text);
}

Result<Geometry> parse_text(const std::string& text, const std::string& path,
                            const ReadOptions& options) {
  const Format* const format = find_format(options.format, path, text);
  if (format != nullptr) return format->parse(text, {display_name(path), options.progress});
  return Error{ErrorCode::kUnreadable,
               {display_name(path), ": is in no format that is known: ", readable_names()}};
}

void note_preparation(const MeshPreparation& found, const std::string& name, Geometry& geometry) {
  const auto note = [&](std::uint64_t count, const char* what) {
    if (count > 0) geometry.notes.push_back(concat({name, ": ", count, what}));
  };
  if (found.turned)
    geometry.notes.push_back(concat({name, ": all triangles were clockwise and have been turned"}));
  note(found.unused_points, " points are in no triangle");
  note(found.repeated_segments, " segments are listed more than once");
}

// The set X may be named without an extension.
std::string resolved(const std::string& path) {
  if (path == "-" || file_exists(path)) return path;
  for (const char* extension : {".node", ".poly"})
    if (file_exists(concat({path, extension}))) return concat({path, extension});
  return path;
}

}  // namespace

std::span<const Format> formats() { return kFormats; }

Result<Geometry> read_geometry(const std::string& given, const ReadOptions& options) {
  const std::string path = resolved(given);
  const Format* format =
      options.format.empty() ? find_by_extension(path) : find_by_name(options.format);
  if (!options.format.empty() && format == nullptr)
    return wrong_usage(
        concat({"unknown format ", in_quotes(options.format), "; there are ", readable_names()}));
  if (format != nullptr && !format->readable())
    return wrong_usage(concat({display_name(path), ": ", format->name,
                               " files cannot be read; readable are ", readable_names()}));
  if (options.format.empty() && triangle_set_name(path) != path)
    return options.siblings == Siblings::kRead
               ? read_triangle_set(path, options.largest, options.progress)
               : read_triangle_file(path, options.largest, options.progress);
  if (format != nullptr && format->read_files != nullptr)
    return format->read_files(path, options.largest, options.progress);
  const auto text = read_input(path, options.largest);
  if (!text) return text.error();
  return parse_text(*text, path, options);
}

Status prepare_geometry(Geometry& geometry, const std::string& name, const Progress& progress) {
  if (geometry.dimension != 2 || geometry.mesh.triangles.empty())
    return Error{ErrorCode::kUnreadable,
                 {name, ": holds no triangles (a mesh X is read from X.node and X.ele)"}};
  const auto found = prepare_mesh(geometry.mesh, geometry.index_base, progress);
  if (!found)
    return Error{found.error().code, {name, ": ", found.error().message}, found.error().ids};
  note_preparation(*found, name, geometry);
  return Ok{};
}

Result<Geometry> read_mesh(const std::string& path, const ReadOptions& options) {
  auto geometry = read_geometry(path, options);
  if (!geometry) return geometry;
  if (Status status = prepare_geometry(*geometry, display_name(path), options.progress); !status)
    return status.error();
  return geometry;
}

Pslg to_pslg(Geometry geometry) {
  return {std::move(geometry.mesh.points), std::move(geometry.mesh.segments),
          std::move(geometry.holes), std::move(geometry.regions),
          std::move(geometry.mesh.point_markers)};
}

Pls to_pls(Geometry geometry) {
  Pls domain;
  for (const TetMesh::Facet& facet : geometry.solid.facets)
    domain.facets.push_back({{{facet.points.begin(), facet.points.end()}}, {}, facet.marker});
  std::move(geometry.polygons.begin(), geometry.polygons.end(), std::back_inserter(domain.facets));
  domain.points = std::move(geometry.solid.points);
  domain.segments = std::move(geometry.solid.segments);
  domain.holes = std::move(geometry.volume_holes);
  domain.regions = std::move(geometry.volume_regions);
  domain.point_markers = std::move(geometry.solid.point_markers);
  return domain;
}

Geometry to_geometry(Pls domain, Index index_base) {
  Geometry geometry;
  geometry.dimension = 3;
  geometry.index_base = index_base;
  for (Pls::Facet& facet : domain.facets) add_facet(geometry, std::move(facet));
  geometry.solid.points = std::move(domain.points);
  geometry.solid.segments = std::move(domain.segments);
  geometry.solid.point_markers = std::move(domain.point_markers);
  geometry.volume_holes = std::move(domain.holes);
  geometry.volume_regions = std::move(domain.regions);
  return geometry;
}

Geometry to_geometry(TriangleMesh mesh, Index index_base) {
  Geometry geometry;
  geometry.mesh = std::move(mesh);
  geometry.index_base = index_base;
  return geometry;
}

Geometry to_geometry(TetMesh mesh, Index index_base) {
  Geometry geometry;
  geometry.dimension = 3;
  geometry.solid = std::move(mesh);
  geometry.index_base = index_base;
  return geometry;
}

bool writes_triangle_files(const std::string& path, const std::string& format_name) {
  if (path == "-") return false;
  if (!format_name.empty()) return format_name == "triangle" || format_name == "poly";
  return find_by_extension(path) == nullptr || triangle_set_name(path) != path;
}

unsigned parts_of(const Geometry& geometry) {
  const bool in_plane = geometry.dimension == 2;
  const auto& segments = in_plane ? geometry.mesh.segments : geometry.solid.segments;
  std::vector<int> segment_markers, facet_markers;
  for (const Segment& s : segments) segment_markers.push_back(s.marker);
  for (const TetMesh::Facet& f : geometry.solid.facets) facet_markers.push_back(f.marker);
  for (const Pls::Facet& f : geometry.polygons) facet_markers.push_back(f.marker);
  const bool cells_are_marked = !without_zeros(cell_markers(geometry)).empty();
  unsigned parts = 0;
  const auto add = [&](unsigned part, bool is_there) { parts |= is_there ? part : 0; };
  add(Part::kPointAttributes, geometry.point_attributes.columns > 0);
  add(Part::kPointMarkers, !without_zeros(geometry.point_markers()).empty());
  add(Part::kCells, geometry.has_cells());
  add(cells_are_marked ? Part::kCellMarkers : Part::kCellAttributes,
      geometry.has_cells() && geometry.cell_attributes.columns > 0);
  add(in_plane ? Part::kSegments : Part::kSegmentsInSpace, !segments.empty());
  add(Part::kSegmentMarkers, !without_zeros(segment_markers).empty());
  add(Part::kFacets, geometry.has_facets());
  add(Part::kFacetMarkers, !without_zeros(facet_markers).empty());
  add(Part::kMarkersBelowOne, mixes_markers(segment_markers) || mixes_markers(facet_markers));
  add(Part::kHolesAndRegions, !geometry.holes.empty() || !geometry.regions.empty() ||
                                  !geometry.volume_holes.empty() ||
                                  !geometry.volume_regions.empty());
  add(Part::kMarkerNames, !geometry.marker_names.empty());
  return parts;
}

std::string parts_left_out(const std::string& path, const std::string& format_name,
                           unsigned parts) {
  constexpr std::pair<unsigned, std::string_view> kWords[] = {
      {Part::kPointAttributes, "attributes of points"},
      {Part::kPointMarkers, "markers of points"},
      {Part::kCells, "triangles or tetrahedra"},
      {Part::kCellAttributes | Part::kCellMarkers, "attributes of triangles or tetrahedra"},
      {Part::kSegments | Part::kSegmentsInSpace, "segments"},
      {Part::kSegmentMarkers, "markers of segments"},
      {Part::kFacets, "facets"},
      {Part::kFacetMarkers, "markers of facets"},
      {Part::kMarkersBelowOne, "markers below 1"},
      {Part::kHolesAndRegions, "holes and regions"},
      {Part::kMarkerNames, "names of markers"}};
  const Format* const format = find_output_format(path, format_name);
  const unsigned left_out = format == nullptr ? 0 : parts & ~format->keeps;
  std::string text;
  for (const auto& [part, words] : kWords)
    if ((left_out & part) != 0) append(text, {text.empty() ? "" : ", ", words});
  return text;
}

Status write_geometry(OutputSet& outputs, const std::string& path, const std::string& format_name,
                      const Geometry& geometry) {
  const Format* const format = find_output_format(path, format_name);
  if (format == nullptr && format_name.empty())
    return wrong_usage(concat(
        {path, ": no format has this extension; name one with --format: ", writable_names()}));
  if (format == nullptr || format->write == nullptr)
    return wrong_usage(
        concat({"cannot write format ", in_quotes(format_name), "; there are ", writable_names()}));
  return format->write(outputs, path, geometry);
}

}  // namespace wellspaced
