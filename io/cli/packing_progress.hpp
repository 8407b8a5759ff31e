// Progress of the command mesh, which writes at a limit what it has.
#pragma once

#include "wellspaced/io/cli/session.hpp"
#include "wellspaced/kernel/progress.hpp"

namespace wellspaced::cli {

/// The session's progress; where there is a limit of time or memory it stops the phase "pack",
/// whose `done` are nodes, when what is left of it is needed to finish and write so many nodes.
/// node_cost: that, for one node, in units of what packed_spacing() takes in the plane: how long
/// that is here and now is measured on a few nodes.
/// Requires: the session outlives it.
Progress packing_progress(Session& session, double node_cost);

}  // namespace wellspaced::cli
