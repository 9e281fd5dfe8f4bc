// A surface within a time limit: it is built in passes, each finer than the one before, and the finest one that is whole when the time is over
// is what there is.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_parameters.hpp"
#include "server/cli/time_limit.hpp"

#include <functional>
#include <memory>

namespace wakesurf::server {

struct BuiltSurface {
    core::Surface surface;
    std::shared_ptr<core::WorkMemory> memory{}; ///< counts the mesh while it is there
    bool cut_short = false;                     ///< the time was over before the last pass
};

/// Builds a surface of these parameters; ends soon after the limit's token has fired.
using BuildPass = std::function<core::Result<BuiltSurface>(const core::SurfaceParameters&)>;

/// What is said where the time is over before there is a surface.
core::Error nothing_within(const TimeLimit& limit);

/// The surface that `build` makes of the parameters, if the time suffices: the same as without a limit. Else the finest before it, and
/// its statistics say so in `stopped`. Without a limit there is one pass. The passes before the last one take about a fifth of its time.
/// @param parameters  with a separation
/// @param coarsest    separation that no pass exceeds, but for the one asked for
/// Error: what `build` reports; Cancelled where the time is over before there is anything.
core::Result<BuiltSurface> build_within(const TimeLimit& limit,
                                        core::SurfaceParameters parameters,
                                        double coarsest,
                                        const BuildPass& build);

} // namespace wakesurf::server
