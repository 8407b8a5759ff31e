// What the command coarsen is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "wellspaced/algorithms/coarsening/coarsen.hpp"
#include "wellspaced/io/cli/arguments.hpp"
#include "wellspaced/io/formats/matrix_files.hpp"
#include "wellspaced/kernel/mesh.hpp"
#include "wellspaced/kernel/result.hpp"

namespace wellspaced::cli {

enum class StatisticsDetail { kNone, kBasic, kFull };

/// What the command line asks for.
struct CoarsenRequest {
  CoarseningOptions options;  ///< what all methods share
  std::vector<CoarseningMethod> methods;
  std::optional<double> beta, factor;  ///< given ones; otherwise each method has its own
  std::optional<CoarseningScheme> scheme;
  std::optional<SpacingMetric> metric;
  StatisticsDetail statistics = StatisticsDetail::kBasic;
  bool multigrid = false;   ///< the profile
  bool for_solver = false;  ///< whether to prepare what a solver needs
  std::vector<const MatrixFormat*> matrices;
};

/// The request; what is wrong with it, `arguments` knows afterwards.
CoarsenRequest read_coarsen_request(Arguments& arguments, std::uint64_t seed);

/// The options for one of the request's methods.
CoarseningOptions options_of(const CoarsenRequest& request, CoarseningMethod method);

/// Numbers of nodes, counted from 0, separated by white space.
/// Errors: kInvalidGeometry for a number out of range; those of reading the file.
Result<std::vector<Index>> read_fixed_points(const std::string& path, std::size_t nodes);

/// The first `nodes` numbers of a file, one a line; fewer if it has no more.
/// Errors: those of reading the file.
Result<std::vector<double>> read_spacing(const std::string& path, std::size_t nodes);

}  // namespace wellspaced::cli
