#include "protocol/files/lines_files.hpp"

#include "protocol/files/csv_name.hpp"
#include "protocol/files/mesh_vtp.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace wakesurf::protocol {

std::string lines_vtp(const core::StreamLines& lines, const std::string& field, double time) {
    const std::size_t count = lines.points.size();
    std::string xml =
        fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
                    "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<FieldData>\n"
                    "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                    "format=\"ascii\">{}</DataArray>\n</FieldData>\n"
                    "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
                    "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n",
                    time, count, lines.lines());
    append_vtp_array(xml, "Float32", field, std::as_bytes(std::span(lines.values)));
    append_vtp_array(xml, "Float32", "IntegrationTime", std::as_bytes(std::span(lines.times)));
    xml += "</PointData>\n<CellData>\n";
    append_vtp_array(xml, "UInt32", "SeedIds", std::as_bytes(std::span(lines.seed)));
    xml += "</CellData>\n<Points>\n";
    append_vtp_array(xml, "Float64", "Points", std::as_bytes(std::span(lines.points)), 3);
    xml += "</Points>\n<Lines>\n";
    std::vector<std::int64_t> connectivity(count);
    std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
    const std::vector<std::int64_t> ends(lines.offsets.begin() + 1, lines.offsets.end());
    append_vtp_array(xml, "Int64", "connectivity", std::as_bytes(std::span(connectivity)));
    append_vtp_array(xml, "Int64", "offsets", std::as_bytes(std::span(ends)));
    xml += "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    return xml;
}

std::string lines_csv(const core::StreamLines& lines, const std::string& field) {
    std::string out = "line,x,y,z,t," + csv_name(field) + "\n";
    for (std::size_t line = 0; line < lines.lines(); ++line)
        for (std::size_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i) {
            const core::Vec3& at = lines.points[i];
            const float value = lines.values[i];
            out += fmt::format("{},{},{},{},{},{}\n", line, at.x, at.y, at.z, lines.times[i],
                               std::isfinite(value) ? fmt::format("{}", value) : "");
        }
    return out;
}

std::string lines_words(const core::StreamLines& lines) {
    std::string out = fmt::format("{} lines, {} points", lines.lines(), lines.points.size());
    if (lines.outside > 0)
        out += fmt::format("; {} of {} seeds lie outside of the flow or in a body", lines.outside,
                           lines.seeds);
    const core::LineEnds& ends = lines.ends;
    out += fmt::format("; ends: {} at the border, {} at walls, {} where the flow rests, "
                       "{} at the longest",
                       ends.domain, ends.wall, ends.rest, ends.limit);
    if (ends.cut > 0)
        out += fmt::format(", {} where a line may have no more points", ends.cut);
    return out;
}

} // namespace wakesurf::protocol
