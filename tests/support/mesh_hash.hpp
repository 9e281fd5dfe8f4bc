// A hash of a mesh with ids, by which tests say that two surfaces are the same to the bit.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstddef>
#include <cstdint>

namespace wakesurf::tests {

/// Returns the 64-bit FNV-1a of ids, cells, s, t and the bytes of positions. Cells count by the ids of their
/// vertices.
inline std::uint64_t hash(const core::KeyedMesh& keyed) {
    std::uint64_t state = 0xcbf29ce484222325ull;
    const auto add = [&](const auto& value) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
        for (std::size_t i = 0; i < sizeof(value); ++i)
            state = (state ^ bytes[i]) * 0x100000001b3ull;
    };
    const core::QuadComplex& mesh = keyed.mesh;
    for (std::size_t i = 0; i < keyed.vertex_id.size(); ++i) {
        add(keyed.vertex_id[i]);
        add(mesh.position[i]);
        add(mesh.s[i]);
        add(mesh.t[i]);
    }
    for (std::size_t i = 0; i < keyed.cell_id.size(); ++i) {
        add(keyed.cell_id[i]);
        for (const auto& slots : {mesh.cells[i].corner, mesh.cells[i].mid})
            for (const core::VertexId v : slots)
                add(v == core::no_vertex ? v : keyed.vertex_id[v]);
    }
    return state;
}

} // namespace wakesurf::tests
