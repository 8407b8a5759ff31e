// The command mesh for domains in space.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "wellspaced/algorithms/packing/interior_packing.hpp"
#include "wellspaced/io/cli/arguments.hpp"
#include "wellspaced/io/cli/session.hpp"
#include "wellspaced/io/cli/stopwatch.hpp"
#include "wellspaced/io/formats/geometry.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::cli {

/// What partial meshes are marked with.
inline constexpr std::string_view kIncompleteMesh =
    "incomplete: a limit was hit before the mesh was done";

/// What --maximal says, and its name.
Maximality maximality_of(Arguments& arguments);
const char* name_of(Maximality maximality);

/// Where the spacing function goes: to the file named, or beside Triangle's files.
std::optional<std::string> spacing_file(const Arguments& arguments, const CommonOptions& common);

/// Meshes `input`, read from `path` in the time `reading`. Returns the exit code.
/// Errors: kUsage for options that are for the plane only; those of pack_domain3.
Result<int> mesh_in_space(const std::string& path, const Geometry& input, PhaseTime reading,
                          Arguments& arguments, Session& session);

}  // namespace wellspaced::cli
