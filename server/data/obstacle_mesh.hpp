// The surface of a dataset's bodies and walls, at which particles stop; with other patches of its boundary where they are wanted.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/wall_geometry.hpp"
#include "core/surface/quad_complex.hpp"
#include "server/data/open_dataset.hpp"

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct Obstacle {
    core::QuadComplex mesh;
    std::size_t walls; ///< vertices; what comes after them closes bodies at the sides of the domain
    std::vector<core::BoundaryPatch>
        patches{}; ///< whose cells come first; empty: the data name none
};

/// Says which patches are wanted.
struct PatchChoice {
    enum class Of {
        Body,  ///< walls but for those in the sides of the domain, closed there
        All,   ///< these and then all other patches
        Named, ///< those of the names, and nothing that closes them
    };
    Of of = Of::Body;
    std::vector<std::string> names{};
};

/// Says that no patch has a name, and which names there are. Its code is NotFound.
core::Error no_patch(const std::string& name, const std::vector<core::BoundaryPatch>& patches);

/// Returns that of the solid nodes, or the walls of the store or of a built-in flow. Error: NotFound without an obstacle, and for
/// names that no patch has; what reading reports.
core::Result<Obstacle> obstacle_of(const LoadedDataset& dataset, const PatchChoice& choice = {});

/// Returns the places beside an obstacle's vertices with the velocity there, both not a number where there is none. Error: as sampling.
core::Result<core::QuadComplex> flow_beside(const LoadedDataset& dataset,
                                            const Obstacle& obstacle,
                                            double time,
                                            const std::stop_token& stop);

/// Returns a field beside an obstacle's vertices, not a number where there is none. Error: NotFound for fields of surfaces alone, and
/// as sampling.
core::Result<std::vector<float>> values_beside(const LoadedDataset& dataset,
                                               const Obstacle& obstacle,
                                               double time,
                                               const std::string& field,
                                               const std::stop_token& stop);

} // namespace wakesurf::server
