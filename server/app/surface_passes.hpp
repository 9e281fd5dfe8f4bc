// A surface within a time limit: it is built in passes, each finer than the one before, and the finest one
// that is complete in time is the result.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/surface_parameters.hpp"
#include "server/app/stop_tokens.hpp"

#include <functional>
#include <memory>

namespace wakesurf::server {

struct BuiltSurface {
    core::Surface surface;
    std::shared_ptr<core::WorkMemory> memory{}; ///< counts the mesh while it is there
    bool cut_short = false;                     ///< the time ran out before the last pass
};

/// Builds a surface of these parameters; ends soon after the limit's token has fired.
using BuildPass = std::function<core::Result<BuiltSurface>(const core::SurfaceParameters&)>;

/// Returns the error for a limit that ends before there is a surface.
core::Error nothing_within(const TimeLimit& limit);

/// Returns the surface that `build` makes of the parameters, if the time suffices: the same as without a
/// limit. Else the finest one before it, with the reason in `stopped` of its statistics. Without a limit
/// there is one pass. The passes before the last one take about a fifth of its time. Error: as `build`;
/// Cancelled if the time ends before there is any surface.
/// @param parameters  with a separation
/// @param coarsest    separation that no pass exceeds, but for the one asked for
core::Result<BuiltSurface> build_within(const TimeLimit& limit,
                                        core::SurfaceParameters parameters,
                                        double coarsest,
                                        const BuildPass& build);

} // namespace wakesurf::server
