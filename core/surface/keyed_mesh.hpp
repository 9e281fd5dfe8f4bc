// A mesh whose vertices and cells have ids that last, and what changed between two states of it: what travels to those who
// already have the one before.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// Ids ascend, one a vertex and one a cell; an id is never used again for something else.
struct KeyedMesh {
    QuadComplex mesh;
    std::vector<std::uint32_t> vertex_id;
    std::vector<std::uint32_t> cell_id;
    double time = 0.0; ///< simulation time
};

/// Vertices and cells by id. Cells name vertices by id as well.
struct MeshDelta {
    struct Vertex {
        std::uint32_t id;
        Vec3 position;
        double s, t;
        Vec3f velocity;
        float deformation;
        std::uint32_t component;
        std::uint8_t approximated;

        bool operator==(const Vertex&) const = default;
    };

    struct KeyedCell {
        std::uint32_t id;
        Cell cell;

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

/// What leads from `before` to `after`; from an empty mesh it is a keyframe. Cost: O(both).
MeshDelta difference(const KeyedMesh& before, const KeyedMesh& after);

/// `before` with a delta applied. Throws std::logic_error when the delta does not fit, which its hash would show as well.
KeyedMesh fold(const KeyedMesh& before, const MeshDelta& delta);

/// 64-bit FNV-1a over ids, cells, parameters and the bytes of positions.
std::uint64_t hash(const KeyedMesh& mesh);

} // namespace wakesurf::core
