#include "protocol/files/surface_lines.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/files/draco_mesh.hpp"
#include "protocol/files/glb_model.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/mesh_ply.hpp"
#include "protocol/files/mesh_vtp.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace wakesurf::protocol {

using core::ContourLine;

namespace {

std::string_view bytes_name(bool polygons) {
    return polygons ? "Polys" : "Lines";
}

/// Holds lines or polygons as a .vtp does: their vertices in order, the end of each, and its value.
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
    std::string out = mesh_comments(metadata, "# ");
    std::size_t points = 0, at = 0;
    std::optional<double> value;
    for (std::size_t i = 0; i < pieces.offsets.size(); ++i) {
        if (!pieces.polygons || value != pieces.values[i])
            out +=
                "o " + std::string(parameter(wanted)) + "=" + number_text(pieces.values[i]) + "\n";
        value = pieces.values[i];
        const auto end = static_cast<std::size_t>(pieces.offsets[i]);
        for (std::size_t k = at; k < end; ++k)
            if (static_cast<std::size_t>(pieces.connectivity[k]) >=
                points) { // each vertex once, in order
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

/// Calls `each` with the vertices of one line or polygon after the other, and its value.
template <class Each>
void for_each_piece(const Pieces& pieces, const Each& each) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < pieces.offsets.size(); ++i) {
        const auto end = static_cast<std::size_t>(pieces.offsets[i]);
        each(std::span(pieces.connectivity).subspan(first, end - first), pieces.values[i]);
        first = end;
    }
}

std::string
lines_ply(const Pieces& pieces, const LinesWanted& wanted, const MeshMetadata& metadata) {
    std::string elements;
    std::size_t count = 0;
    for_each_piece(pieces, [&](std::span<const std::int64_t> vertices, double value) {
        if (pieces.polygons) {
            put_bytes(elements, static_cast<std::uint8_t>(vertices.size()));
            for (const std::int64_t v : vertices)
                put_bytes(elements, static_cast<std::int32_t>(v));
            put_bytes(elements, value);
            ++count;
            return;
        }
        for (std::size_t k = 1; k < vertices.size(); ++k, ++count) {
            put_bytes(elements, static_cast<std::int32_t>(vertices[k - 1]));
            put_bytes(elements, static_cast<std::int32_t>(vertices[k]));
            put_bytes(elements, value);
        }
    });
    std::string out = ply_head(metadata);
    out += "element vertex " + std::to_string(pieces.points.size()) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement " +
           (pieces.polygons ? "face " : "edge ") + std::to_string(count) +
           (pieces.polygons ? "\nproperty list uchar int vertex_indices"
                            : "\nproperty int vertex1\nproperty int vertex2") +
           "\nproperty double " + std::string(parameter(wanted)) + "\nend_header\n";
    for (const core::Vec3& point : pieces.points)
        put_bytes(out, point);
    return out + elements;
}

core::Result<std::string>
lines_glb(const Pieces& pieces, const LinesWanted& wanted, const MeshMetadata& metadata) {
    const auto positions = narrowed_positions(pieces.points);
    if (!positions)
        return tl::unexpected(positions.error());
    std::vector<std::uint32_t> indices;
    std::vector<float> values(pieces.points.size());
    for_each_piece(pieces, [&](std::span<const std::int64_t> vertices, double value) {
        const auto at = [&](std::size_t k) { return static_cast<std::uint32_t>(vertices[k]); };
        for (std::size_t k = 0; k < vertices.size(); ++k)
            values[at(k)] = static_cast<float>(value);
        // Polygons are parts of one cell, and convex: a fan of triangles covers each.
        for (std::size_t k = pieces.polygons ? 2 : 1; k < vertices.size(); ++k) {
            if (pieces.polygons)
                indices.push_back(at(0));
            indices.insert(indices.end(), {at(k - 1), at(k)});
        }
    });
    tinygltf::Model model;
    glb::PlainArrays arrays(model);
    tinygltf::Primitive primitive;
    primitive.indices = arrays.indices(indices);
    primitive.attributes["POSITION"] = arrays.vertices(*positions);
    glb::set_bounds(model.accessors.back(), *positions);
    primitive.attributes[parameter(wanted) == "t" ? "_T" : "_S"] = arrays.vertices(values);
    arrays.finish();
    glb::add_mesh(model, std::move(primitive),
                  pieces.polygons ? TINYGLTF_MODE_TRIANGLES : TINYGLTF_MODE_LINE);
    return glb::file_of(model, metadata.version, glb::extras(metadata));
}

} // namespace

core::Result<std::string> lines_file(MeshFormat format,
                                     const SurfaceLines& lines,
                                     const LinesWanted& wanted,
                                     const MeshMetadata& metadata) {
    const Pieces pieces = pieces_of(lines, wanted);
    switch (format) {
    case MeshFormat::Vtp:
        return lines_vtp(pieces, wanted, metadata);
    case MeshFormat::Obj:
        return lines_obj(pieces, wanted, metadata);
    case MeshFormat::Ply:
        return lines_ply(pieces, wanted, metadata);
    case MeshFormat::Glb:
        return lines_glb(pieces, wanted, metadata);
    case MeshFormat::Drc:
        break;
    }
    return core::fail(core::Error::Code::Unsupported, "lines cannot be written as .drc",
                      "choose .vtp, .glb, .ply or .obj");
}

using core::Error;
using core::SurfaceKind;

namespace {

constexpr std::string_view timelines = "timelines";
constexpr std::string_view arrows_name = "arrows";
constexpr std::string_view points_name = "points";

/// Returns the name of lines of particles of one seed. Empty for time surfaces, each of whose points is a
/// particle of its own, and level surfaces.
std::string_view seed_lines(SurfaceKind kind) {
    switch (kind) {
    case SurfaceKind::Stream:
        return "streamlines";
    case SurfaceKind::Path:
        return "pathlines";
    case SurfaceKind::Streak:
        return "streaklines";
    case SurfaceKind::Time:
    case SurfaceKind::Level:
        break;
    }
    return {};
}

/// Returns the largest distance across the surface.
double widest(std::span<const double> parameter, std::span<const double> unit, bool wraps) {
    if (parameter.empty())
        return 0.0;
    const auto [low, high] = std::minmax_element(parameter.begin(), parameter.end());
    double longest = 0.0;
    for (const double length : unit)
        if (std::isfinite(length))
            longest = std::max(longest, length);
    return longest * (wraps ? 1.0 : *high - *low);
}

template <class Number>
bool read_number(std::string_view text, Number& out) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), out);
    return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

/// Reads `every=D,width=W` in either order, or N for the first of them. Returns false for any other text, and
/// for a value that is no length.
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

std::string_view parameter(const LinesWanted& wanted) {
    return wanted.along == LinesWanted::Along::Release ? "t" : "s";
}

core::Result<LinesWanted> read_lines(std::string_view text, SurfaceKind kind, MeshFormat format) {
    const std::string_view own = seed_lines(kind);
    const std::string kind_name(name(kind));
    const auto refuse = [](std::string what, std::string hint) {
        return core::fail(Error::Code::InvalidArgument, std::move(what), std::move(hint));
    };
    if (text == points_name && format == MeshFormat::Ply)
        return LinesWanted{.form = LinesWanted::Form::Points};
    if (text == points_name)
        return refuse("points cannot be written as ." + std::string(extension(format)),
                      "choose .ply");
    if (format == MeshFormat::Drc)
        return refuse("lines cannot be written as .drc", "choose .vtp, .glb, .ply or .obj");
    if (kind == SurfaceKind::Level)
        return refuse("a level surface has no lines: no particle runs along it",
                      "build a stream surface for its lines");
    const bool flows = kind == SurfaceKind::Stream || kind == SurfaceKind::Path;
    const std::string_view arrows_usage = "arrows:every=0.5,width=0.1";
    const std::string base(own.substr(0, own.size() - std::min<std::size_t>(own.size(), 5)));
    const std::string usage =
        own.empty() ? "all of it is one age; as in " + std::string(arrows_usage)
                    : "as in timelines:8, " + std::string(own) + ":every=0.5, " + base +
                          "ribbons:every=0.5,width=0.1 or " + std::string(arrows_usage);
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view which = text.substr(0, colon);
    LinesWanted out;
    out.seeds_flow = flows;
    const bool ribbons = !own.empty() && (which == "timeribbons" || which == base + "ribbons");
    if (which == arrows_name)
        out.form = LinesWanted::Form::Arrows;
    else if (ribbons)
        out.form = LinesWanted::Form::Ribbons;
    else if (own.empty() || (which != timelines && which != own))
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
        if (const double across = widest(along, unit, wraps); wanted.width > across)
            return core::fail(Error::Code::InvalidArgument,
                              "the ribbons would be wider than the surface, which is " +
                                  number_text(across) + " across at most",
                              "give a smaller width");
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
            auto cut = core::arrows(mesh, out.lines, wanted.spacing, wanted.width,
                                    {wanted.seeds_flow, wraps});
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

} // namespace wakesurf::protocol
