// What a surface is built from, as values: a compute thread needs nothing else.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/lattice.hpp"
#include "server/session/surface_fields.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace wakesurf::server {

struct SurfaceJob {
    std::uint32_t number = 0; ///< of the surface on the wire
    std::uint32_t epoch = 0;
    core::Rake rake;
    core::SurfaceParameters parameters;
    std::shared_ptr<const core::Flow> flow;
    std::shared_ptr<const core::StoreReader> store; ///< of the flow; null for a built-in one
    std::vector<SurfaceField> fields;
    protocol::Lattice lattice;
};

/// Whether it looks different at different times of the session's clock.
inline bool moves(const core::SurfaceParameters& parameters) {
    return parameters.kind != core::SurfaceKind::Stream;
}

/// 1 or -1: which way time runs along it. Surfaces of both directions are shown at the times of the forward part.
inline double time_sign(const core::SurfaceParameters& parameters) {
    return parameters.direction == core::Direction::Backward ? -1.0 : 1.0;
}

/// The time of the session's clock at which it is complete.
inline double end_time(const core::SurfaceParameters& parameters) {
    return parameters.from + time_sign(parameters) * std::abs(parameters.to - parameters.from);
}

} // namespace wakesurf::server
