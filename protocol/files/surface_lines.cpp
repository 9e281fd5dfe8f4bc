#include "protocol/files/surface_lines.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/files/mesh_comments.hpp"
#include "protocol/files/number_text.hpp"
#include "protocol/files/vtp_parts.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <span>

namespace wakesurf::protocol {

using core::ContourLine;
using core::Error;
using core::SurfaceKind;

namespace {

constexpr std::string_view timelines = "timelines";
constexpr std::string_view arrows_name = "arrows";

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

std::string_view bytes_name(bool polygons) {
    return polygons ? "Polys" : "Lines";
}

/// What a .vtp says of lines or polygons: their vertices in order, each one's end, and its value.
struct Pieces {
    std::vector<core::Vec3> points;
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<double> values;
    bool polygons = false;
};

Pieces pieces_of(const SurfaceLines& lines, const LinesWanted& wanted) {
    Pieces out;
    out.polygons = wanted.form != LinesWanted::Form::Lines;
    if (out.polygons) {
        const core::Cutouts& cut = lines.cutouts;
        out.points = cut.points;
        out.connectivity.assign(cut.connectivity.begin(), cut.connectivity.end());
        out.offsets.assign(cut.ends.begin(), cut.ends.end());
        out.values = cut.value;
        return out;
    }
    for (const ContourLine& line : lines.lines) {
        const auto first = static_cast<std::int64_t>(out.points.size());
        for (const core::Vec3& point : line.points) {
            out.connectivity.push_back(static_cast<std::int64_t>(out.points.size()));
            out.points.push_back(point);
        }
        if (line.closed)
            out.connectivity.push_back(first);
        out.offsets.push_back(static_cast<std::int64_t>(out.connectivity.size()));
        out.values.push_back(line.value);
    }
    return out;
}

std::string
lines_vtp(const Pieces& pieces, const LinesWanted& wanted, const MeshMetadata& metadata) {
    const auto bytes = [](const auto& array) { return std::as_bytes(std::span(array)); };
    const std::size_t count = pieces.offsets.size();
    const std::string kind(bytes_name(pieces.polygons));
    std::string xml = vtp_head(metadata);
    xml += vtp_piece(
               {pieces.points.size(), pieces.polygons ? 0 : count, pieces.polygons ? count : 0}) +
           "<CellData>\n";
    append_vtp_array(xml, "Float64", parameter(wanted), bytes(pieces.values));
    xml += "</CellData>\n<Points>\n";
    append_vtp_array(xml, "Float64", "Points", bytes(pieces.points), 3);
    xml += "</Points>\n<" + kind + ">\n";
    append_vtp_array(xml, "Int64", "connectivity", bytes(pieces.connectivity));
    append_vtp_array(xml, "Int64", "offsets", bytes(pieces.offsets));
    xml += "</" + kind + ">\n</Piece>\n";
    xml += vtp_tail();
    return xml;
}

std::string
lines_obj(const Pieces& pieces, const LinesWanted& wanted, const MeshMetadata& metadata) {
    std::string out;
    for (const std::string& line : mesh_comments(metadata))
        out += "# " + line + "\n";
    std::size_t points = 0, at = 0;
    std::optional<double> value;
    for (std::size_t i = 0; i < pieces.offsets.size(); ++i) {
        if (!pieces.polygons || value != pieces.values[i])
            out +=
                "o " + std::string(parameter(wanted)) + "=" + number_text(pieces.values[i]) + "\n";
        value = pieces.values[i];
        const auto end = static_cast<std::size_t>(pieces.offsets[i]);
        for (std::size_t k = at; k < end; ++k)
            if (static_cast<std::size_t>(pieces.connectivity[k]) >= points) { // each once, in order
                const core::Vec3& p = pieces.points[points++];
                out += "v " + number_text(p.x) + " " + number_text(p.y) + " " + number_text(p.z) +
                       "\n";
            }
        out += pieces.polygons ? 'f' : 'l';
        for (; at < end; ++at) // .obj counts from 1
            out += " " + number_text(static_cast<std::size_t>(pieces.connectivity[at]) + 1);
        out += '\n';
    }
    return out;
}

template <class Number>
bool read_number(std::string_view text, Number& out) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), out);
    return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

/// `every=D,width=W` in either order, or N for the first of them. Returns false where that is none of it, or not a length.
bool read_measures(std::string_view text, LinesWanted& out) {
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(','));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        const bool every = word.starts_with("every=");
        const bool width = word.starts_with("width=");
        if (every || width) {
            double& number = every ? out.spacing : out.width;
            if (number != 0.0 || !read_number(word.substr(6), number) || !std::isfinite(number) ||
                !(number > 0.0))
                return false;
        } else if (out.values != 0 || !read_number(word, out.values) || out.values == 0) {
            return false;
        }
    }
    return (out.values == 0) != (out.spacing == 0.0) &&
           (out.width > 0.0) == (out.form != LinesWanted::Form::Lines);
}

} // namespace

core::Result<LinesWanted> read_lines(std::string_view text, SurfaceKind kind) {
    const std::string_view own = seed_lines(kind);
    const std::string kind_name(name(kind));
    const auto refuse = [](std::string what, std::string hint) {
        return core::fail(Error::Code::InvalidArgument, std::move(what), std::move(hint));
    };
    if (own.empty())
        return refuse("a " + kind_name + " surface has no such lines",
                      "all of it is one age; build a streak surface for its timelines");
    const std::string base(own.substr(0, own.size() - 5)); // without `lines`
    const bool flows = kind == SurfaceKind::Stream || kind == SurfaceKind::Path;
    const std::string usage = "as in timelines:8, " + std::string(own) + ":every=0.5, " + base +
                              "ribbons:every=0.5,width=0.1" +
                              (flows ? " or arrows:every=0.5,width=0.1" : "");
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view which = text.substr(0, colon);
    LinesWanted out;
    if (which == arrows_name && !flows)
        return refuse(
            "a " + kind_name + " surface has no arrows",
            "the flow does not run along its lines; those of stream and path surfaces do");
    const bool ribbons = which == "timeribbons" || which == base + "ribbons";
    if (which == arrows_name)
        out.form = LinesWanted::Form::Arrows;
    else if (ribbons)
        out.form = LinesWanted::Form::Ribbons;
    else if (which != timelines && which != own)
        return refuse("a " + kind_name + " surface has no lines called '" +
                          std::string(which.substr(0, 64)) + "'",
                      usage);
    out.along = which.starts_with("time") ? LinesWanted::Along::Release : LinesWanted::Along::Seed;
    const std::string_view measures = text.substr(std::min(colon + 1, text.size()));
    const bool read = read_measures(measures, out);
    if (out.values > most_line_values || (!read && out.form == LinesWanted::Form::Lines &&
                                          measures.find('=') == std::string_view::npos))
        return refuse(
            "the number of lines is not between 1 and " + std::to_string(most_line_values), usage);
    if (!read || (out.form == LinesWanted::Form::Arrows && out.values > 0))
        return refuse("'" + std::string(measures.substr(0, 64)) + "' are not the measures of " +
                          std::string(which),
                      usage);
    if (out.spacing > 0.0 && out.width > out.spacing)
        return refuse("the width of " + std::string(which) +
                          " is larger than the distance between them",
                      usage);
    return out;
}

core::Result<SurfaceLines>
surface_lines(const core::QuadComplex& mesh, const LinesWanted& wanted, bool closed) {
    const bool release = wanted.along == LinesWanted::Along::Release;
    const auto& along = release ? mesh.t : mesh.s;
    const bool wraps = closed && !release;
    std::vector<double> unit;
    if (wanted.values == 0 || wanted.form != LinesWanted::Form::Lines)
        unit = core::lengths_per_unit(mesh, along, wraps);
    std::vector<core::EvenLevel> levels;
    if (wanted.values > 0) {
        for (const double value : core::evenly_spaced(along, wanted.values, wraps))
            levels.push_back({value, 0.0});
    } else {
        auto even = core::even_levels(mesh, along, unit, wanted.spacing, wraps, most_line_values);
        if (!even)
            return tl::unexpected(even.error());
        levels = *std::move(even);
    }
    SurfaceLines out;
    if (wanted.form == LinesWanted::Form::Ribbons) {
        auto cut = core::ribbons(mesh, along, unit, levels, wanted.width, wraps);
        if (!cut)
            return tl::unexpected(cut.error());
        out.cutouts = *std::move(cut);
    } else if (wanted.values > 0) {
        std::vector<double> values;
        for (const core::EvenLevel& level : levels)
            values.push_back(level.value);
        out.lines = core::contour_lines(mesh, along, values, {wraps, {}});
    } else {
        out.lines = core::even_lines(mesh, along, unit, levels, wanted.spacing, wraps);
        if (wanted.form == LinesWanted::Form::Arrows) {
            auto cut = core::arrows(mesh, out.lines, wanted.spacing, wanted.width, wraps);
            if (!cut)
                return tl::unexpected(cut.error());
            out.cutouts = *std::move(cut);
        }
    }
    const bool lines = wanted.form == LinesWanted::Form::Lines;
    if (lines ? out.lines.empty() : out.cutouts.ends.empty())
        return core::fail(Error::Code::NotFound,
                          lines && wanted.values > 0
                              ? "there are no such lines: " + std::string(parameter(wanted)) +
                                    " is the same everywhere on this surface"
                              : "there is no room for them on this surface",
                          lines && wanted.values > 0 ? "" : "give smaller distances");
    return out;
}

core::Result<std::string> lines_file(MeshFormat format,
                                     const SurfaceLines& lines,
                                     const LinesWanted& wanted,
                                     const MeshMetadata& metadata) {
    if (format == MeshFormat::Vtp)
        return lines_vtp(pieces_of(lines, wanted), wanted, metadata);
    if (format == MeshFormat::Obj)
        return lines_obj(pieces_of(lines, wanted), wanted, metadata);
    return core::fail(Error::Code::Unsupported,
                      "lines cannot be written as ." + std::string(extension(format)),
                      "choose .vtp or .obj");
}

} // namespace wakesurf::protocol
