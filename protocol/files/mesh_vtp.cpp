#include "protocol/files/mesh_vtp.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/files/base64.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <zlib.h>

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18;
constexpr int fastest = 1; // for floats a higher level saves 3 % and takes three times as long

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string compressed(std::span<const std::byte> block) {
    auto size = compressBound(static_cast<uLong>(block.size()));
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                  reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()),
                  fastest) != Z_OK)
        throw std::bad_alloc(); // the only possible failure: the buffer is large enough
    out.resize(size);
    return out;
}

// Returns the text between the tags of a `<DataArray format="binary">` in a file that says header_type="UInt64" and
// compressor="vtkZLibDataCompressor": blocks, each compressed by zlib, all as base64. Readers that cannot take appended data, as
// Debian 12's ParaView, read this. Same bytes, same text, on any number of threads. Cost: 15 ms a MB and core.
std::string vtk_inline(std::span<const std::byte> data) {
    std::vector<std::string> blocks((data.size() + block_bytes - 1) / block_bytes);
    oneapi::tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        const std::size_t first = i * block_bytes;
        blocks[i] = compressed(data.subspan(first, std::min(block_bytes, data.size() - first)));
    });
    std::vector<std::uint64_t> header{blocks.size(), block_bytes, data.size() % block_bytes};
    std::string all;
    for (std::string& block : blocks) {
        header.push_back(block.size());
        all += block;
        block = {};
    }
    std::string out;
    append_base64(out, text_of(std::as_bytes(std::span(header))));
    append_base64(out, all);
    return out;
}

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

void field_points(std::string& xml, std::string_view name, std::span<const core::Vec3> points) {
    std::vector<double> numbers;
    for (const core::Vec3& point : points)
        numbers.insert(numbers.end(), {point.x, point.y, point.z});
    field_numbers(xml, name, numbers, 3);
}

void field_data(std::string& xml, const MeshMetadata& metadata) {
    xml += "<FieldData>\n";
    field_text(xml, "kind", name(metadata.parameters.kind));
    if (metadata.parameters.field)
        field_text(xml, "field", *metadata.parameters.field);
    else
        field_points(xml, "rake", metadata.rake.points);
    if (!metadata.parameters.field && tells_kind(metadata.rake.kind))
        field_text(xml, "rakeKind", name(metadata.rake.kind));
    if (metadata.parameters.rake2)
        field_points(xml, "rake2", metadata.parameters.rake2->points);
    if (metadata.parameters.rake2 && tells_kind(metadata.parameters.rake2->kind))
        field_text(xml, "rake2Kind", name(metadata.parameters.rake2->kind));
    if (metadata.parameters.sweep)
        field_points(xml, "sweep", std::span(&*metadata.parameters.sweep, 1));
    field_numbers(xml, "from", std::span(&metadata.parameters.from, 1));
    field_numbers(xml, "to", std::span(&metadata.parameters.to, 1));
    if (metadata.time) // VTK's own name: ParaView puts a series of files in order by it
        field_numbers(xml, "TimeValue", std::span(&*metadata.time, 1));
    for (const auto& [name, value] : given_numbers(metadata.parameters))
        field_numbers(xml, name, std::span(&value, 1));
    field_numbers(xml, "separation", std::span(&metadata.separation, 1));
    const double pieces = metadata.tessellate;
    if (metadata.tessellate > 1)
        field_numbers(xml, "tessellate", std::span(&pieces, 1));
    field_text(xml, "dataset", metadata.dataset);
    field_text(xml, "version", metadata.version);
    for (const auto& [name, value] : metadata.errors)
        field_numbers(xml, name, std::span(&value, 1));
    if (!metadata.stopped.empty())
        field_text(xml, "stopped", metadata.stopped);
    xml += "</FieldData>\n";
}

} // namespace

std::string vtp_head(const MeshMetadata& metadata) {
    std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                      "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
                      "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n";
    if (!metadata.recipe.empty())
        xml += "<!-- " + metadata.recipe + " -->\n";
    field_data(xml, metadata);
    return xml;
}

std::string_view vtp_tail() {
    return "</PolyData>\n</VTKFile>\n";
}

std::string vtp_piece(const VtpCounts& counts) {
    return "<Piece NumberOfPoints=\"" + std::to_string(counts.points) +
           "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(counts.lines) +
           "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(counts.polygons) + "\">\n";
}

void append_vtp_array(std::string& xml,
                      std::string_view type,
                      std::string_view name,
                      std::span<const std::byte> bytes,
                      int components) {
    xml += "<DataArray type=\"";
    xml += type;
    xml += "\" Name=\"" + escaped(name) + "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"binary\">" + vtk_inline(bytes) + "</DataArray>\n";
}

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
