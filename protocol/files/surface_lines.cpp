#include "protocol/files/surface_lines.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/files/mesh_comments.hpp"
#include "protocol/files/number_text.hpp"
#include "protocol/files/vtp_parts.hpp"

#include <charconv>
#include <span>

namespace wakesurf::protocol {

using core::ContourLine;
using core::Error;
using core::SurfaceKind;

namespace {

constexpr std::string_view timelines = "timelines";

/// What the particles of one seed form. Empty for time surfaces: each of their points is a particle of its own.
std::string_view seed_lines(SurfaceKind kind) {
    switch (kind) {
    case SurfaceKind::Stream:
        return "streamlines";
    case SurfaceKind::Path:
        return "pathlines";
    case SurfaceKind::Streak:
        return "streaklines";
    case SurfaceKind::Time:
        break;
    }
    return {};
}

std::string_view parameter(const LinesWanted& wanted) {
    return wanted.along == LinesWanted::Along::Release ? "t" : "s";
}

std::string lines_vtp(const std::vector<ContourLine>& lines,
                      const LinesWanted& wanted,
                      const MeshMetadata& metadata) {
    std::vector<core::Vec3> points;
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<double> values;
    for (const ContourLine& line : lines) {
        const auto first = static_cast<std::int64_t>(points.size());
        for (const core::Vec3& point : line.points) {
            connectivity.push_back(static_cast<std::int64_t>(points.size()));
            points.push_back(point);
        }
        if (line.closed)
            connectivity.push_back(first);
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        values.push_back(line.value);
    }
    const auto bytes = [](const auto& array) { return std::as_bytes(std::span(array)); };
    std::string xml = vtp_head(metadata);
    xml += vtp_piece({points.size(), lines.size(), 0}) + "<CellData>\n";
    append_vtp_array(xml, "Float64", parameter(wanted), bytes(values));
    xml += "</CellData>\n<Points>\n";
    append_vtp_array(xml, "Float64", "Points", bytes(points), 3);
    xml += "</Points>\n<Lines>\n";
    append_vtp_array(xml, "Int64", "connectivity", bytes(connectivity));
    append_vtp_array(xml, "Int64", "offsets", bytes(offsets));
    xml += "</Lines>\n</Piece>\n";
    xml += vtp_tail();
    return xml;
}

std::string lines_obj(const std::vector<ContourLine>& lines,
                      const LinesWanted& wanted,
                      const MeshMetadata& metadata) {
    std::string out;
    for (const std::string& line : mesh_comments(metadata))
        out += "# " + line + "\n";
    std::size_t next = 1; // .obj counts from 1
    for (const ContourLine& line : lines) {
        out += "o " + std::string(parameter(wanted)) + "=" + number_text(line.value) + "\n";
        for (const core::Vec3& p : line.points)
            out += "v " + number_text(p.x) + " " + number_text(p.y) + " " + number_text(p.z) + "\n";
        out += 'l';
        for (std::size_t i = 0; i < line.points.size(); ++i)
            out += " " + number_text(next + i);
        if (line.closed)
            out += " " + number_text(next);
        out += '\n';
        next += line.points.size();
    }
    return out;
}

} // namespace

core::Result<LinesWanted> read_lines(std::string_view text, SurfaceKind kind) {
    const std::string_view own = seed_lines(kind);
    const std::string kind_name(name(kind));
    if (own.empty())
        return core::fail(Error::Code::InvalidArgument,
                          "a " + kind_name + " surface has no such lines",
                          "all of it is one age; build a streak surface for its timelines");
    const std::string usage = "as in timelines:8 or " + std::string(own) + ":8";
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view which = text.substr(0, colon);
    if (which != timelines && which != own)
        return core::fail(Error::Code::InvalidArgument,
                          "a " + kind_name + " surface has no lines called '" +
                              std::string(which.substr(0, 64)) + "'",
                          usage);
    const std::string_view number = text.substr(std::min(colon + 1, text.size()));
    LinesWanted out{which == timelines ? LinesWanted::Along::Release : LinesWanted::Along::Seed, 0};
    const auto read = std::from_chars(number.data(), number.data() + number.size(), out.values);
    if (read.ec != std::errc{} || read.ptr != number.data() + number.size() || out.values == 0 ||
        out.values > most_line_values)
        return core::fail(
            Error::Code::InvalidArgument,
            "the number of lines is not between 1 and " + std::to_string(most_line_values), usage);
    return out;
}

core::Result<std::vector<ContourLine>> surface_lines(const core::QuadComplex& mesh,
                                                     const LinesWanted& wanted) {
    const auto& along = wanted.along == LinesWanted::Along::Release ? mesh.t : mesh.s;
    auto lines = core::contour_lines(mesh, along, core::evenly_spaced(along, wanted.values));
    if (lines.empty())
        return core::fail(Error::Code::NotFound,
                          "there are no such lines: " + std::string(parameter(wanted)) +
                              " is the same everywhere on this surface");
    return lines;
}

core::Result<std::string> lines_file(MeshFormat format,
                                     const std::vector<ContourLine>& lines,
                                     const LinesWanted& wanted,
                                     const MeshMetadata& metadata) {
    if (format == MeshFormat::Vtp)
        return lines_vtp(lines, wanted, metadata);
    if (format == MeshFormat::Obj)
        return lines_obj(lines, wanted, metadata);
    return core::fail(Error::Code::Unsupported,
                      "lines cannot be written as ." + std::string(extension(format)),
                      "choose .vtp or .obj");
}

} // namespace wakesurf::protocol
