// A surface -> the bytes of a .vtp file (VTK XML PolyData, inline, compressed by zlib): one polygon a cell,
// corners and hanging nodes in order, so that the polygons share points and the file is as watertight as the
// surface.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Writes coordinates as computed (Float64). Same input, same bytes. About 60 bytes and 2 microseconds a
/// vertex and core. REQUIRES: every per-vertex array of `mesh` and `scalars` has mesh.vertices() entries;
/// `deformation` may be empty.
std::string mesh_vtp(const core::QuadComplex& mesh,
                     const MeshMetadata& metadata,
                     const MeshScalars& scalars = {});

/// Returns a file of a mesh, or of lines on it, up to its `<Piece`: the description of the surface.
std::string vtp_head(const MeshMetadata& metadata);

/// Returns the file after its `</Piece>`.
std::string_view vtp_tail();

struct VtpCounts {
    std::size_t points = 0, lines = 0, polygons = 0;
};

std::string vtp_piece(const VtpCounts& counts);

/// Appends an array as `<DataArray>`.
/// @param type   `Float64`, `Int64`, ...
/// @param bytes  of its values, little-endian
void append_vtp_array(std::string& xml,
                      std::string_view type,
                      std::string_view name,
                      std::span<const std::byte> bytes,
                      int components = 1);

/// A surface as VTK's polygonal data have it: polygons one after the other, and named arrays at the vertices.
/// For .vtp files, and for VTK itself (importer/filter).
struct VtkPolygons {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets; ///< the end of each in `connectivity`
};

inline VtkPolygons vtk_polygons(const core::QuadComplex& mesh) {
    VtkPolygons out;
    out.connectivity.reserve(mesh.cells.size() * 5);
    out.offsets.reserve(mesh.cells.size());
    for (const core::Cell& cell : mesh.cells) {
        const core::CellPolygon outline = core::polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i)
            out.connectivity.push_back(outline.vertex[i]);
        out.offsets.push_back(static_cast<std::int64_t>(out.connectivity.size()));
    }
    return out;
}

/// Calls visit(name, values, components) for each array that the mesh has, in the order of files; `values` is
/// a vector of one type or another.
template <class Visit>
void each_vtk_array(const core::QuadComplex& mesh, const Visit& visit) {
    std::vector<float> speed(mesh.vertices());
    for (std::size_t v = 0; v < speed.size(); ++v)
        speed[v] = static_cast<float>(mesh.speed(static_cast<core::VertexId>(v)));
    visit("s", mesh.s, 1);
    visit("t", mesh.t, 1);
    visit("speed", speed, 1);
    visit("velocity", mesh.velocity, 3);
    if (!mesh.deformation.empty() || mesh.vertices() == 0)
        visit("deformation", mesh.deformation, 1);
    visit("component", mesh.component, 1);
    visit("approximated", mesh.approximated, 1);
    if (!mesh.error.empty())
        visit("error", mesh.error, 1);
    if (!mesh.interval_error.empty())
        visit("interval_error", mesh.interval_error, 1);
}

} // namespace wakesurf::protocol
