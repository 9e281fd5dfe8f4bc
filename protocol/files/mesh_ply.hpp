// A surface -> the bytes of a .ply file (binary, little-endian).
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

namespace wakesurf::protocol {

enum class PlyElements : std::uint8_t { Cells, Points };

/// Writes a quad for each cell without hanging nodes, triangles for the others, sharing vertices. Vertex
/// properties: double x y z s t, float speed vx vy vz, then what VTK and ParaView show of a .ply: float nx ny
/// nz, float u v (s and t once more), uchar red green blue (speed from the slowest to the fastest vertex,
/// viridis); float deformation (if the mesh has it), uint component, uchar approximated, float error and
/// interval_error (if the mesh has them), float <scalar> for each scalar, its name as one word. Metadata in comments. Same input, same
/// bytes. REQUIRES: as mesh_vtp. @param elements  Points: no cells, and a float radius a vertex, of a disc
/// across its normal; discs of all vertices leave no hole in a flat cell, and reach beyond the border
std::string mesh_ply(const core::QuadComplex& mesh,
                     const MeshMetadata& metadata,
                     const MeshScalars& scalars = {},
                     PlyElements elements = PlyElements::Cells);

static_assert(std::endian::native == std::endian::little, "the file says binary_little_endian");

/// Appends a number as the file has it.
template <class T>
void put_bytes(std::string& out, T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Returns the head of a .ply file, of a mesh or of lines, up to the first element.
inline std::string ply_head(const MeshMetadata& metadata) {
    return "ply\nformat binary_little_endian 1.0\n" + mesh_comments(metadata, "comment ");
}

} // namespace wakesurf::protocol
