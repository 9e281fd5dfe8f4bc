#include "protocol/files/wall_vtp.hpp"

#include "protocol/files/mesh_vtp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::protocol {

namespace {

/// Triangles come as cells whose last corner is there twice.
VtkPolygons polygons_of(const core::QuadComplex& mesh) {
    VtkPolygons out;
    for (const core::Cell& cell : mesh.cells) {
        const std::size_t corners = cell.corner[2] == cell.corner[3] ? 3 : 4;
        out.connectivity.insert(out.connectivity.end(), cell.corner.begin(),
                                cell.corner.begin() + static_cast<std::ptrdiff_t>(corners));
        out.offsets.push_back(static_cast<std::int64_t>(out.connectivity.size()));
    }
    return out;
}

/// As VTK writes texts: the numbers of their bytes, and 0 after each.
std::string names_array(const std::vector<core::BoundaryPatch>& patches) {
    std::string xml = fmt::format("<DataArray type=\"String\" Name=\"PatchNames\" "
                                  "NumberOfTuples=\"{}\" format=\"ascii\">",
                                  patches.size());
    for (const core::BoundaryPatch& patch : patches) {
        for (const char byte : patch.name)
            xml += fmt::format("{} ", static_cast<unsigned>(static_cast<unsigned char>(byte)));
        xml += "0 ";
    }
    return xml + "</DataArray>\n";
}

} // namespace

std::string wall_vtp(const core::QuadComplex& mesh,
                     const std::vector<core::BoundaryPatch>& patches,
                     const std::vector<WallValues>& values,
                     std::optional<double> time) {
    const std::string when =
        time ? fmt::format("<DataArray type=\"Float64\" Name=\"TimeValue\" "
                           "NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
                           *time)
             : "";
    std::string xml = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
        "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<FieldData>\n"
        "{}{}</FieldData>\n"
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<PointData>\n",
        when, patches.empty() ? "" : names_array(patches), mesh.vertices(), mesh.cells.size());
    for (const WallValues& each : values)
        append_vtp_array(xml, "Float32", each.name, std::as_bytes(std::span(each.values)),
                         each.components);
    xml += "</PointData>\n<CellData>\n";
    if (!patches.empty()) {
        std::vector<std::int32_t> numbers;
        for (std::size_t i = 0; i < patches.size(); ++i)
            numbers.insert(numbers.end(), patches[i].triangles, static_cast<std::int32_t>(i));
        numbers.resize(mesh.cells.size(), -1);
        append_vtp_array(xml, "Int32", "Patch", std::as_bytes(std::span(numbers)));
    }
    xml += "</CellData>\n<Points>\n";
    append_vtp_array(xml, "Float64", "Points", std::as_bytes(std::span(mesh.position)), 3);
    xml += "</Points>\n<Polys>\n";
    const VtkPolygons polygons = polygons_of(mesh);
    append_vtp_array(xml, "Int64", "connectivity", std::as_bytes(std::span(polygons.connectivity)));
    append_vtp_array(xml, "Int64", "offsets", std::as_bytes(std::span(polygons.offsets)));
    xml += "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    return xml;
}

} // namespace wakesurf::protocol
