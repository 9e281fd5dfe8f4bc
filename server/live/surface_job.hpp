// The input of a surface's build, as values: a compute thread needs nothing else.
#pragma once

#include "core/surface/request/surface_plan.hpp"
#include "protocol/wire/lattice.hpp"
#include "server/data/surface_fields.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace wakesurf::server {

struct SurfaceJob {
    std::uint32_t number = 0; ///< of the surface on the wire
    std::uint32_t epoch = 0;
    core::SurfacePlan plan;
    std::shared_ptr<const store::StoreReader> store;    ///< of the flow; null for a built-in one
    std::shared_ptr<const store::StoreScalars> scalars; ///< of the store
    std::vector<SurfaceField> fields;
    protocol::Lattice lattice;
};

} // namespace wakesurf::server
