#include "protocol/files/lines_file.hpp"

#include "protocol/files/draco_mesh.hpp"
#include "protocol/files/glb_model.hpp"
#include "protocol/files/mesh_comments.hpp"
#include "protocol/files/number_text.hpp"
#include "protocol/files/ply_parts.hpp"
#include "protocol/files/vtp_parts.hpp"

#include <algorithm>
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
            put(elements, static_cast<std::uint8_t>(vertices.size()));
            for (const std::int64_t v : vertices)
                put(elements, static_cast<std::int32_t>(v));
            put(elements, value);
            ++count;
            return;
        }
        for (std::size_t k = 1; k < vertices.size(); ++k, ++count) {
            put(elements, static_cast<std::int32_t>(vertices[k - 1]));
            put(elements, static_cast<std::int32_t>(vertices[k]));
            put(elements, value);
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
        put(out, point);
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

} // namespace wakesurf::protocol
