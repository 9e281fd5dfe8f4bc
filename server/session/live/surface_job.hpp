// What a surface is built from, as values: a compute thread needs nothing else.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/wire/lattice.hpp"
#include "server/session/data/surface_fields.hpp"

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
    std::shared_ptr<const store::StoreReader> store; ///< of the flow; null for a built-in one
    std::vector<SurfaceField> fields;
    protocol::Lattice lattice;
};

} // namespace wakesurf::server
