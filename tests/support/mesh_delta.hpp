// The difference of two states of a mesh, by id, and a hash of a state: twins for the tests of all that
// changes a mesh.
#pragma once

#include "core/surface/keyed_mesh.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::tests {

/// Holds changed vertices and cells by id. Cells name vertices by id as well.
struct MeshDelta {
    struct Vertex {
        std::uint32_t id;
        core::Vec3 position;
        double s, t;
        core::Vec3f velocity;
        float deformation;
        std::uint32_t component;
        std::uint8_t approximated;

        bool operator==(const Vertex&) const = default;
    };

    struct KeyedCell {
        std::uint32_t id;
        core::Cell cell;

        bool operator==(const KeyedCell&) const = default;
    };

    double time = 0.0;
    bool deformation = false;                           ///< the mesh has that array
    std::vector<Vertex> vertices_added, vertices_moved; ///< moved: anything of them changed
    std::vector<std::uint32_t> vertices_removed;
    std::vector<KeyedCell> cells_added, cells_changed;
    std::vector<std::uint32_t> cells_removed;
    std::uint64_t hash = 0; ///< of the state after it
};

/// Returns the delta from `before` to `after`; from an empty mesh it is a keyframe. Cost: O(both).
MeshDelta difference(const core::KeyedMesh& before, const core::KeyedMesh& after);

/// Returns `before` with a delta applied. Throws std::logic_error if the delta does not fit, which its hash
/// would show as well.
core::KeyedMesh fold(const core::KeyedMesh& before, const MeshDelta& delta);

/// Returns the 64-bit FNV-1a hash of ids, cells, parameters and the bytes of positions.
std::uint64_t hash(const core::KeyedMesh& mesh);

} // namespace wakesurf::tests
