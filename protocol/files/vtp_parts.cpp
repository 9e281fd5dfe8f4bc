#include "protocol/files/vtp_parts.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/files/number_text.hpp"
#include "protocol/files/vtk_inline.hpp"

#include <bit>

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
    if (!metadata.stopped.empty())
        field_text(xml, "stopped", metadata.stopped);
    xml += "</FieldData>\n";
}

} // namespace

std::string vtp_head(const MeshMetadata& metadata) {
    std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                      "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
                      "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n";
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

} // namespace wakesurf::protocol
