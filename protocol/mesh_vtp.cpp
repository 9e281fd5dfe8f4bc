#include "protocol/mesh_vtp.hpp"

#include "protocol/number_text.hpp"
#include "protocol/surface_names.hpp"

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <span>
#include <string_view>

namespace wakesurf::protocol {

namespace {

static_assert(std::endian::native == std::endian::little, "the file says byte_order LittleEndian");

/// The XML in front of the data and, in the same order, the arrays it points into.
struct AppendedFile {
    std::string xml;
    std::vector<std::span<const std::byte>> blocks;
    std::uint64_t offset = 0;
};

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

/// VTK writes strings as the numbers of their bytes, ended by 0.
void field_text(std::string& xml, std::string_view name, std::string_view value) {
    xml += "<DataArray type=\"String\" Name=\"";
    xml += name;
    xml += "\" NumberOfTuples=\"1\" format=\"ascii\">";
    for (const char c : value)
        xml += std::to_string(static_cast<unsigned char>(c)) + " ";
    xml += "0</DataArray>\n";
}

void field_numbers(std::string& xml,
                   std::string_view name,
                   std::span<const double> values,
                   std::size_t components = 1) {
    xml += "<DataArray type=\"Float64\" Name=\"";
    xml += name;
    xml += "\" NumberOfComponents=\"" + std::to_string(components) + "\" NumberOfTuples=\"" +
           std::to_string(values.size() / components) + "\" format=\"ascii\">";
    for (const double value : values)
        xml += number_text(value) + " ";
    xml += "</DataArray>\n";
}

template <class T>
void block(AppendedFile& file,
           std::string_view type,
           std::string_view name,
           const std::vector<T>& values,
           int components = 1) {
    file.xml += "<DataArray type=\"";
    file.xml += type;
    file.xml += "\" Name=\"" + escaped(name) + "\" NumberOfComponents=\"" +
                std::to_string(components) + "\" format=\"appended\" offset=\"" +
                std::to_string(file.offset) + "\"/>\n";
    file.blocks.push_back(std::as_bytes(std::span(values)));
    file.offset += sizeof(std::uint64_t) + file.blocks.back().size();
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

void field_points(std::string& xml, std::string_view name, std::span<const core::Vec3> points) {
    std::vector<double> numbers;
    for (const core::Vec3& point : points)
        numbers.insert(numbers.end(), {point.x, point.y, point.z});
    field_numbers(xml, name, numbers, 3);
}

void field_data(std::string& xml, const MeshMetadata& metadata) {
    xml += "<FieldData>\n";
    field_text(xml, "kind", name(metadata.kind));
    field_points(xml, "rake", metadata.rake);
    if (!metadata.rake2.empty())
        field_points(xml, "rake2", metadata.rake2);
    if (metadata.sweep)
        field_points(xml, "sweep", std::span(&*metadata.sweep, 1));
    field_numbers(xml, "from", std::span(&metadata.from, 1));
    field_numbers(xml, "to", std::span(&metadata.to, 1));
    if (metadata.release_until)
        field_numbers(xml, "releaseUntil", std::span(&*metadata.release_until, 1));
    field_numbers(xml, "separation", std::span(&metadata.separation, 1));
    field_text(xml, "dataset", metadata.dataset);
    field_text(xml, "version", metadata.version);
    xml += "</FieldData>\n";
}

void point_data(AppendedFile& file,
                const core::QuadComplex& mesh,
                const std::vector<float>& speed,
                const MeshScalars& scalars) {
    file.xml += "<PointData Scalars=\"speed\" Vectors=\"velocity\">\n";
    block(file, "Float64", "s", mesh.s);
    block(file, "Float64", "t", mesh.t);
    block(file, "Float32", "speed", speed);
    block(file, "Float32", "velocity", mesh.velocity, 3);
    if (!mesh.deformation.empty() || mesh.vertices() == 0)
        block(file, "Float32", "deformation", mesh.deformation);
    block(file, "UInt32", "component", mesh.component);
    block(file, "UInt8", "approximated", mesh.approximated);
    for (const auto& [name, values] : scalars) {
        assert(values.size() == mesh.vertices());
        block(file, "Float32", name, values);
    }
    file.xml += "</PointData>\n";
}

} // namespace

std::string
mesh_vtp(const core::QuadComplex& mesh, const MeshMetadata& metadata, const MeshScalars& scalars) {
    static_assert(sizeof(core::Vec3) == 3 * sizeof(double) &&
                  sizeof(core::Vec3f) == 3 * sizeof(float));
    const Polygons polygons = polygons_of(mesh);
    const std::vector<float> speed = speeds_of(mesh);
    AppendedFile file;
    file.xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\">\n<PolyData>\n";
    field_data(file.xml, metadata);
    file.xml += "<Piece NumberOfPoints=\"" + std::to_string(mesh.vertices()) +
                "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
                std::to_string(mesh.cells.size()) + "\">\n";
    point_data(file, mesh, speed, scalars);
    file.xml += "<Points>\n";
    block(file, "Float64", "Points", mesh.position, 3);
    file.xml += "</Points>\n<Polys>\n";
    block(file, "Int64", "connectivity", polygons.connectivity);
    block(file, "Int64", "offsets", polygons.offsets);
    file.xml += "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    std::string bytes = std::move(file.xml);
    bytes.reserve(bytes.size() + file.offset + 64);
    for (const auto data : file.blocks) {
        const auto size =
            std::bit_cast<std::array<char, sizeof(std::uint64_t)>>(std::uint64_t{data.size()});
        bytes.append(size.data(), size.size());
        bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
    }
    bytes += "\n</AppendedData>\n</VTKFile>\n";
    return bytes;
}

} // namespace wakesurf::protocol
