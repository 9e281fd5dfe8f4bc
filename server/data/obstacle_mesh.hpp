// The surface of a dataset's bodies and walls, at which particles stop.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "server/data/open_dataset.hpp"

#include <cstddef>

namespace wakesurf::server {

struct Obstacle {
    core::QuadComplex mesh;
    std::size_t walls; ///< vertices; what comes after them closes bodies at the sides of the domain
};

/// Returns that of the solid nodes, or the walls of the store or of a built-in flow. Error: NotFound without an obstacle, what reading reports.
core::Result<Obstacle> obstacle_of(const LoadedDataset& dataset);

} // namespace wakesurf::server
