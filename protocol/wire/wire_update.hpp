// An update as frames: its numbers, then Draco's bytes of its points, cut if they are long. Blocks of points
// are encoded in parallel.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_edit.hpp"
#include "protocol/wire/wire_mesh.hpp"
#include "protocol/wire/wire_residuals.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// The edit from the clients' mesh to a new one, by the ids of vertices and cells. Only the sender knows ids:
/// on the wire vertices and cells have places, and keep their order as long as they live.
/// Maps ids to places: id[i], ascending, is at place[i].
struct Places {
    std::vector<std::uint32_t> id;
    std::vector<std::uint32_t> place;

    std::size_t bytes() const { return (id.capacity() + place.capacity()) * sizeof(id[0]); }
};

struct MeshPlaces {
    Places vertices;
    Places cells;

    std::size_t bytes() const { return vertices.bytes() + cells.bytes(); }
};

struct MeshMatch {
    TopologyEdit edit; ///< but for the moved vertices
    /// The cells that stay, the replaced ones as they were; empty if no cell changes.
    std::vector<core::Cell> kept;
    MeshPlaces places; ///< of the new mesh
    /// The cells of the new mesh, by place, with places for vertices.
    std::vector<core::Cell> cells;
    std::uint32_t vertices_stay = 0;
};

/// Matches two meshes. REQUIRES: ids ascend, as many as there are vertices and cells, and cells name vertices
/// that exist. Cost: O(both + new log new).
/// @param held      of the mesh before; empty for a KEY
/// @param before    its cells
/// @param in_order  a KEY has its vertices in order along the surface, by s and t, which are finite; else by
/// their ids
MeshMatch match(const MeshPlaces& held,
                std::span<const core::Cell> before,
                const core::KeyedMesh& mesh,
                bool in_order);

/// Returns Corrupt for ids that do not ascend or are not one for each.
core::Result<void> check_ids(const core::KeyedMesh& mesh);

/// Writes an update. Error: OverLimit, and as write_block.
/// @param header   of the update; members that differ between frames are filled in
/// @param numbers  the ranges of a KEY, and the topology
/// @param points   in their order on the wire; may be empty
core::Result<SharedFrames> write_update(FrameHeader header,
                                        std::vector<std::uint32_t> numbers,
                                        std::span<const Residuals> points);

} // namespace wakesurf::protocol
