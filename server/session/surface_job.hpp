// One build of a surface, from values to encoded frames: a coarse pass that is on the screen within a few
// milliseconds, then the surface as asked for. Runs on a compute thread and touches nothing shared.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/surface/surface_statistics.hpp"
#include "protocol/lattice.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

namespace wakesurf::server {

using Frames = std::vector<std::shared_ptr<const std::vector<std::byte>>>;

struct SurfaceJob {
    std::uint32_t number = 0; ///< of the surface on the wire
    std::uint32_t epoch = 0;
    core::Rake rake;
    core::SurfaceParameters parameters;
    std::shared_ptr<const core::Flow> flow;
    protocol::Lattice lattice;
    std::uint64_t coarse_quads = 0; ///< most of the coarse pass; 0: no coarse pass
};

/// A whole surface, encoded once for everybody. Immutable once published.
struct SurfaceState {
    std::uint32_t epoch = 0;
    bool final = false;
    Frames frames;
    std::uint32_t crc = 0;
    core::SurfaceStatistics statistics;
    double seconds = 0.0; ///< to build and encode
};

using PublishState = std::function<void(core::Result<SurfaceState>)>;

/// Publishes one or two states, or one error, or nothing once `stop` has fired. Never throws. Returns the seconds a
/// coarse pass was at work when `stop` ended it, else 0.
double
run_surface_job(const SurfaceJob& job, const std::stop_token& stop, const PublishState& publish);

} // namespace wakesurf::server
