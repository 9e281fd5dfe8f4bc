#include "protocol/files/mesh_vtp.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/files/number_text.hpp"
#include "protocol/files/vtk_inline.hpp"

#include <bit>
#include <cassert>
#include <cstdint>
#include <span>
#include <string_view>

namespace wakesurf::protocol {

namespace {

static_assert(std::endian::native == std::endian::little, "the file says byte_order LittleEndian");

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
void block(std::string& xml,
           std::string_view type,
           std::string_view name,
           const std::vector<T>& values,
           int components = 1) {
    xml += "<DataArray type=\"";
    xml += type;
    xml += "\" Name=\"" + escaped(name) + "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"binary\">" + vtk_inline(std::as_bytes(std::span(values))) +
           "</DataArray>\n";
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
    if (metadata.time) // VTK's own name: ParaView puts a series of files in order by it
        field_numbers(xml, "TimeValue", std::span(&*metadata.time, 1));
    if (metadata.release_until)
        field_numbers(xml, "releaseUntil", std::span(&*metadata.release_until, 1));
    field_numbers(xml, "separation", std::span(&metadata.separation, 1));
    field_text(xml, "dataset", metadata.dataset);
    field_text(xml, "version", metadata.version);
    xml += "</FieldData>\n";
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
    std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                      "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
                      "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n";
    field_data(xml, metadata);
    xml += "<Piece NumberOfPoints=\"" + std::to_string(mesh.vertices()) +
           "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
           std::to_string(mesh.cells.size()) + "\">\n";
    point_data(xml, mesh, scalars);
    xml += "<Points>\n";
    block(xml, "Float64", "Points", mesh.position, 3);
    xml += "</Points>\n<Polys>\n";
    const Polygons polygons = polygons_of(mesh);
    block(xml, "Int64", "connectivity", polygons.connectivity);
    block(xml, "Int64", "offsets", polygons.offsets);
    xml += "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    return xml;
}

} // namespace wakesurf::protocol
