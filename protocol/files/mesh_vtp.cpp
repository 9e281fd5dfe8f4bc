#include "protocol/files/mesh_vtp.hpp"

#include "protocol/files/vtk_arrays.hpp"
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

template <class T>
constexpr std::string_view type_name = "";
template <>
constexpr std::string_view type_name<double> = "Float64";
template <>
constexpr std::string_view type_name<float> = "Float32";
template <>
constexpr std::string_view type_name<core::Vec3f> = "Float32";
template <>
constexpr std::string_view type_name<std::uint32_t> = "UInt32";
template <>
constexpr std::string_view type_name<std::uint8_t> = "UInt8";

void point_data(std::string& xml, const core::QuadComplex& mesh, const MeshScalars& scalars) {
    xml += "<PointData Scalars=\"speed\" Vectors=\"velocity\">\n";
    each_vtk_array(
        mesh, [&]<class T>(std::string_view name, const std::vector<T>& values, int components) {
            if (name != "error" || !scalars.contains("error")) // a field of the data has priority
                block(xml, type_name<T>, name, values, components);
        });
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
    const VtkPolygons polygons = vtk_polygons(mesh);
    block(xml, "Int64", "connectivity", polygons.connectivity);
    block(xml, "Int64", "offsets", polygons.offsets);
    xml += "</Polys>\n</Piece>\n";
    xml += vtp_tail();
    return xml;
}

} // namespace wakesurf::protocol
