#include "protocol/files/mesh_vtp.hpp"

#include "protocol/files/vtp_parts.hpp"

#include <cassert>
#include <cstdint>
#include <span>
#include <string_view>

namespace wakesurf::protocol {

namespace {

template <class T>
void block(std::string& xml,
           std::string_view type,
           std::string_view name,
           const std::vector<T>& values,
           int components = 1) {
    append_vtp_array(xml, type, name, std::as_bytes(std::span(values)), components);
}

struct Polygons {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
};

Polygons polygons_of(const core::QuadComplex& mesh) {
    Polygons out;
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

std::vector<float> speeds_of(const core::QuadComplex& mesh) {
    std::vector<float> out(mesh.vertices());
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = static_cast<float>(mesh.speed(static_cast<core::VertexId>(v)));
    return out;
}

void point_data(std::string& xml, const core::QuadComplex& mesh, const MeshScalars& scalars) {
    xml += "<PointData Scalars=\"speed\" Vectors=\"velocity\">\n";
    block(xml, "Float64", "s", mesh.s);
    block(xml, "Float64", "t", mesh.t);
    block(xml, "Float32", "speed", speeds_of(mesh));
    block(xml, "Float32", "velocity", mesh.velocity, 3);
    if (!mesh.deformation.empty() || mesh.vertices() == 0)
        block(xml, "Float32", "deformation", mesh.deformation);
    block(xml, "UInt32", "component", mesh.component);
    block(xml, "UInt8", "approximated", mesh.approximated);
    if (!mesh.error.empty() && !scalars.contains("error")) // a field of the data goes before it
        block(xml, "Float32", "error", mesh.error);
    for (const auto& [name, values] : scalars) {
        assert(values.size() == mesh.vertices());
        block(xml, "Float32", name, values);
    }
    xml += "</PointData>\n";
}

} // namespace

std::string
mesh_vtp(const core::QuadComplex& mesh, const MeshMetadata& metadata, const MeshScalars& scalars) {
    static_assert(sizeof(core::Vec3) == 3 * sizeof(double) &&
                  sizeof(core::Vec3f) == 3 * sizeof(float));
    std::string xml = vtp_head(metadata);
    xml += vtp_piece({mesh.vertices(), 0, mesh.cells.size()});
    point_data(xml, mesh, scalars);
    xml += "<Points>\n";
    block(xml, "Float64", "Points", mesh.position, 3);
    xml += "</Points>\n<Polys>\n";
    const Polygons polygons = polygons_of(mesh);
    block(xml, "Int64", "connectivity", polygons.connectivity);
    block(xml, "Int64", "offsets", polygons.offsets);
    xml += "</Polys>\n</Piece>\n";
    xml += vtp_tail();
    return xml;
}

} // namespace wakesurf::protocol
