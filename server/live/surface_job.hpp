// The input of a surface's build and of each of its passes, as values: a compute thread needs nothing else.
#pragma once

#include "core/surface/request/surface_plan.hpp"
#include "protocol/wire/lattice.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "server/data/surface_fields.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

using protocol::Phase;

/// One pass over a surface: its quality and its time.
struct SurfacePass {
    Phase phase = Phase::Final;
    std::uint64_t quads = 0;    ///< the budget of a coarse or refined pass
    std::optional<double> time; ///< of the session's clock; empty: at the end
    double separation = 0.0;    ///< the least of such a pass
    /// Checks the state that the pass without it led to: estimates its error between stored times, and compares it with
    /// its twin.
    bool checking = false;
};

struct SurfaceJob {
    std::uint32_t number = 0; ///< of the surface on the wire
    std::uint32_t epoch = 0;
    core::SurfacePlan plan;
    std::shared_ptr<const store::StoreReader> store;    ///< of the flow; null for a built-in one
    std::shared_ptr<const store::StoreScalars> scalars; ///< of the store
    std::vector<SurfaceField> fields;
    protocol::Lattice lattice;
    std::shared_ptr<const core::SurfacePlan> twin{};        ///< what it is compared with
    std::shared_ptr<const store::StoreReader> twin_store{}; ///< of the twin's flow
    std::string twin_left_out{}; ///< why it has no twin though one was asked for
};

} // namespace wakesurf::server
