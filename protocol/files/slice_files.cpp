#include "protocol/files/slice_files.hpp"

#include "protocol/files/csv_name.hpp"
#include "protocol/files/mesh_vtp.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace wakesurf::protocol {

namespace {

std::vector<core::Vec3> places(const core::SliceRaster& raster) {
    std::vector<core::Vec3> out;
    out.reserve(raster.values.size());
    for (std::size_t row = 0; row < raster.rows; ++row)
        for (std::size_t column = 0; column < raster.columns; ++column)
            out.push_back(raster.place(column, row));
    return out;
}

} // namespace

std::string slice_vts(std::span<const NamedRaster> fields, double time) {
    assert(!fields.empty());
    const core::SliceRaster& first = fields.front().raster;
    const std::vector<core::Vec3> points = places(first);
    const std::string extent = fmt::format("0 {} 0 {} 0 0", first.columns - 1, first.rows - 1);
    std::string xml = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"StructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
        "compressor=\"vtkZLibDataCompressor\">\n<StructuredGrid WholeExtent=\"{0}\">\n<FieldData>\n"
        "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">{1}</DataArray>\n</FieldData>\n<Piece Extent=\"{0}\">\n<PointData>\n",
        extent, time);
    for (const NamedRaster& each : fields)
        append_vtp_array(xml, "Float32", each.name, std::as_bytes(std::span(each.raster.values)),
                         1);
    xml += "</PointData>\n<Points>\n";
    append_vtp_array(xml, "Float64", "Points", std::as_bytes(std::span(points)), 3);
    xml += "</Points>\n</Piece>\n</StructuredGrid>\n</VTKFile>\n";
    return xml;
}

std::string slice_csv(std::span<const NamedRaster> fields) {
    assert(!fields.empty());
    std::string out = "x,y,z";
    for (const NamedRaster& each : fields)
        out += "," + csv_name(each.name);
    out += "\n";
    const std::vector<core::Vec3> at = places(fields.front().raster);
    for (std::size_t i = 0; i < at.size(); ++i) {
        std::string values;
        bool any = false;
        for (const NamedRaster& each : fields) {
            const float value = each.raster.values[i];
            any = any || std::isfinite(value);
            values += std::isfinite(value) ? fmt::format(",{}", value) : ",";
        }
        if (any)
            out += fmt::format("{},{},{}{}\n", at[i].x, at[i].y, at[i].z, values);
    }
    return out;
}

} // namespace wakesurf::protocol
