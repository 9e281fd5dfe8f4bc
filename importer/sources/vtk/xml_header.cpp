#include "importer/sources/vtk/xml_header.hpp"

#include "importer/base/reading_bounds.hpp"
#include "importer/sources/files/bounded_xml.hpp"

#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkXMLDataParser.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

// A file that was cut off parses, up to its end, like one that was not.
core::Result<void> check_ending(const ListedFile& file) {
    std::ifstream in(file.path, std::ios::binary | std::ios::ate);
    if (!in)
        return core::fail(Error::Code::Io, "cannot open " + file.name);
    const auto size = static_cast<std::streamoff>(in.tellg());
    constexpr std::streamoff most = 256;
    std::string tail(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, most)), '\0');
    in.seekg(size - static_cast<std::streamoff>(tail.size()));
    in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
    if (size <= 0)
        return core::fail(Error::Code::Corrupt, file.name + " is empty");
    if (tail.find("</VTKFile>") == std::string::npos)
        return core::fail(Error::Code::Corrupt, file.name + " is truncated or not a VTK XML file");
    return {};
}

// Returns the text with its elements closed where it ends behind a tag.
std::optional<std::string> closed_behind_tag(std::istream& in) {
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const auto last = text.find_last_not_of(" \t\r\n");
    return last != std::string::npos && text[last] == '>' ? closed_xml(text) : std::nullopt;
}

constexpr std::int64_t most_nodes_of_piece = std::int64_t{1} << 48; // of 12 bytes each: 3 PiB

using Extent = std::array<std::int64_t, 6>;

// Counts modulo 2^64: an extent for which that matters is refused as too large later.
std::uint64_t cells(const Extent& e) {
    return static_cast<std::uint64_t>(e[1] - e[0]) * static_cast<std::uint64_t>(e[3] - e[2]) *
           static_cast<std::uint64_t>(e[5] - e[4]);
}

bool overlap(const Extent& a, const Extent& b) {
    return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3] && a[4] < b[5] && b[4] < a[5];
}

std::optional<Extent> extent_of(vtkXMLDataElement& element, const char* name) {
    std::array<int, 6> read{};
    if (element.GetVectorAttribute(name, 6, read.data()) != 6)
        return std::nullopt;
    Extent extent;
    std::copy(read.begin(), read.end(), extent.begin());
    return extent;
}

std::vector<vtkXMLDataElement*> pieces_of(vtkXMLDataElement& primary) {
    std::vector<vtkXMLDataElement*> out;
    for (int i = 0; i < primary.GetNumberOfNestedElements(); ++i)
        if (auto* element = primary.GetNestedElement(i);
            std::string_view(element->GetName()) == "Piece")
            out.push_back(element);
    return out;
}

// `ghosts`: pieces of parallel files may overlap where they repeat a neighbour's cells.
core::Result<void> check_extents(vtkXMLDataElement& primary, const std::string& name, bool ghosts) {
    const auto damaged =
        core::fail(Error::Code::Corrupt, name + " has pieces that do not fit its extent");
    constexpr std::size_t most = 10'000;
    const auto whole = extent_of(primary, "WholeExtent");
    if (!whole)
        return damaged;
    std::int64_t nodes = 1;
    for (std::size_t axis = 0; axis < 6; axis += 2) {
        const auto here = std::max<std::int64_t>((*whole)[axis + 1] - (*whole)[axis] + 1, 1);
        if (nodes > most_nodes_of_piece / here)
            return core::fail(Error::Code::Corrupt,
                              name + " says that it has more nodes than memory can hold");
        nodes *= here;
    }
    for (std::size_t axis = 0; axis < 6; axis += 2)
        if ((*whole)[axis] >= (*whole)[axis + 1])
            return {}; // no cells to cover; code that needs three dimensions says so
    std::vector<Extent> found;
    std::uint64_t covered = 0;
    for (auto* element : pieces_of(primary)) {
        const auto piece = extent_of(*element, "Extent");
        if (!piece || found.size() == most)
            return damaged;
        for (std::size_t axis = 0; axis < 6; axis += 2)
            if ((*piece)[axis] < (*whole)[axis] || (*piece)[axis + 1] > (*whole)[axis + 1] ||
                (*piece)[axis] >= (*piece)[axis + 1])
                return damaged;
        if (!ghosts && std::any_of(found.begin(), found.end(),
                                   [&](const Extent& e) { return overlap(e, *piece); }))
            return damaged;
        found.push_back(*piece);
        covered += cells(*piece);
    }
    if (ghosts ? covered < cells(*whole) : covered != cells(*whole))
        return damaged;
    return {};
}

core::Result<void> check_numbers(vtkXMLDataElement& image, const std::string& name) {
    const auto check = [&](const char* attribute, int count) {
        std::array<double, 9> values{};
        return image.GetAttribute(attribute) == nullptr ||
               (image.GetVectorAttribute(attribute, count, values.data()) == count &&
                std::all_of(values.begin(), values.end(),
                            [](double v) { return std::isfinite(v); }));
    };
    for (const auto& [attribute, count] :
         {std::pair{"Origin", 3}, {"Spacing", 3}, {"Direction", 9}})
        if (!check(attribute, count))
            return core::fail(Error::Code::Corrupt, name + " has a damaged " + attribute + ": " +
                                                        std::to_string(count) +
                                                        " finite numbers are expected");
    return {};
}

core::Result<void> check_counts(vtkXMLDataElement& primary, const std::string& name) {
    for (auto* piece : pieces_of(primary))
        for (const char* attribute : {"NumberOfPoints", "NumberOfCells"}) {
            vtkTypeInt64 count = -1;
            const bool cells_of_other_names = piece->GetAttribute(attribute) == nullptr;
            if (cells_of_other_names && std::string_view(attribute) == "NumberOfCells")
                continue;
            if (piece->GetScalarAttribute(attribute, count) == 0 || count < 0 ||
                count > most_nodes_of_piece)
                return core::fail(Error::Code::Corrupt,
                                  name + " has a piece whose " + attribute + " is not a count");
        }
    return {};
}

} // namespace

core::Result<XmlHeader> read_xml_header(const ListedFile& file, bool listing) {
    made_progress();
    XmlHeader header;
    std::ifstream in(file.path, std::ios::binary);
    std::istringstream closed;
    if (auto whole = check_ending(file); !whole) {
        const auto text = listing ? closed_behind_tag(in) : std::nullopt;
        if (!text)
            return tl::unexpected(whole.error());
        closed.str(*text);
        header.cut = true;
    }
    const auto parsed = parse_xml(header.cut ? static_cast<std::istream&>(closed) : in, file.name);
    if (!parsed)
        return tl::unexpected(parsed.error());
    vtkXMLDataParser* parser = *parsed;
    header.root = parser->GetRootElement();
    header.appended = parser->GetAppendedDataPosition();
    const char* type = header.root ? header.root->GetAttribute("type") : nullptr;
    header.type = type == nullptr ? "" : type;
    header.primary =
        type == nullptr ? nullptr : header.root->FindNestedElementWithName(header.type.c_str());
    if (header.primary == nullptr)
        return core::fail(Error::Code::Corrupt, file.name + " is damaged or not a VTK XML file");
    return header;
}

core::Result<void> check_xml_header(const XmlHeader& header, const std::string& name) {
    auto& primary = *header.primary;
    if (primary.GetAttribute("TimeValues") != nullptr)
        return core::fail(Error::Code::Unsupported, name + " holds several time-steps in one file",
                          "write one file per time-step and a .pvd that lists them");
    const bool parallel = header.type.starts_with("P") && header.type != "PolyData";
    const std::string serial = parallel ? header.type.substr(1) : header.type;
    if (serial == "ImageData")
        if (auto numbers = check_numbers(primary, name); !numbers)
            return numbers;
    if (serial == "ImageData" || serial == "RectilinearGrid" || serial == "StructuredGrid")
        return check_extents(primary, name, parallel);
    if (!parallel && (serial == "UnstructuredGrid" || serial == "PolyData"))
        return check_counts(primary, name);
    return {};
}

namespace {

// Serial and parallel files have field data within what they hold, collections of blocks beside it.
vtkXMLDataElement* field_data_of(vtkXMLDataElement& root) {
    const char* type = root.GetAttribute("type");
    auto* primary = type == nullptr ? nullptr : root.FindNestedElementWithName(type);
    auto* inside = primary == nullptr ? nullptr : primary->FindNestedElementWithName("FieldData");
    return inside != nullptr ? inside : root.FindNestedElementWithName("FieldData");
}

void set_compressor(vtkXMLDataParser& parser, vtkXMLDataElement& root) {
    const char* name = root.GetAttribute("compressor");
    const std::string_view wanted = name == nullptr ? "" : name;
    if (wanted == "vtkZLibDataCompressor")
        parser.SetCompressor(vtkSmartPointer<vtkZLibDataCompressor>::New());
    if (wanted == "vtkLZ4DataCompressor")
        parser.SetCompressor(vtkSmartPointer<vtkLZ4DataCompressor>::New());
    if (wanted == "vtkLZMADataCompressor")
        parser.SetCompressor(vtkSmartPointer<vtkLZMADataCompressor>::New());
}

template <class Number>
std::optional<double> first_value(vtkXMLDataParser& parser, vtkXMLDataElement& array, int type) {
    Number value{};
    const char* format = array.GetAttribute("format");
    const std::string_view how = format == nullptr ? "" : format;
    vtkTypeInt64 offset = 0;
    std::size_t read = 0;
    if (how == "appended" && array.GetScalarAttribute("offset", offset) != 0)
        read = parser.ReadAppendedData(offset, &value, 0, 1, type);
    else if (how != "appended")
        read = parser.ReadInlineData(&array, how == "ascii" ? 1 : 0, &value, 0, 1, type);
    if (read != 1)
        return std::nullopt;
    return static_cast<double>(value);
}

using Read = std::optional<double> (*)(vtkXMLDataParser&, vtkXMLDataElement&, int);

std::optional<double> number_in(vtkXMLDataParser& parser, vtkXMLDataElement& array) {
    struct Type {
        std::string_view name;
        Read read;
        int vtk;
    };

    constexpr std::array<Type, 10> types{{{"Float64", first_value<double>, VTK_DOUBLE},
                                          {"Float32", first_value<float>, VTK_FLOAT},
                                          {"Int64", first_value<vtkTypeInt64>, VTK_TYPE_INT64},
                                          {"UInt64", first_value<vtkTypeUInt64>, VTK_TYPE_UINT64},
                                          {"Int32", first_value<vtkTypeInt32>, VTK_TYPE_INT32},
                                          {"UInt32", first_value<vtkTypeUInt32>, VTK_TYPE_UINT32},
                                          {"Int16", first_value<vtkTypeInt16>, VTK_TYPE_INT16},
                                          {"UInt16", first_value<vtkTypeUInt16>, VTK_TYPE_UINT16},
                                          {"Int8", first_value<vtkTypeInt8>, VTK_TYPE_INT8},
                                          {"UInt8", first_value<vtkTypeUInt8>, VTK_TYPE_UINT8}}};
    const char* const given = array.GetAttribute("type");
    const std::string_view wanted = given == nullptr ? "Float64" : given;
    const auto type = std::find_if(types.begin(), types.end(),
                                   [&](const Type& each) { return each.name == wanted; });
    const auto value = type == types.end() ? std::nullopt : type->read(parser, array, type->vtk);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

} // namespace

core::Result<StatedTime> xml_time(const ListedFile& file) {
    std::ifstream in(file.path, std::ios::binary);
    auto parser = vtkSmartPointer<vtkXMLDataParser>::New();
    parser->SetStream(&in);
    const bool parsed = parser->Parse() != 0;
    vtkXMLDataElement* const root = parsed ? parser->GetRootElement() : nullptr;
    vtkXMLDataElement* const data = root == nullptr ? nullptr : field_data_of(*root);
    StatedTime out;
    if (data == nullptr)
        return out;
    set_compressor(*parser, *root);
    for (const auto& [name, means] : time_arrays) {
        auto* const array = data->FindNestedElementWithNameAndAttribute("DataArray", "Name", name);
        if (array == nullptr)
            continue;
        const auto value = number_in(*parser, *array);
        if (!value && name == std::string_view("TimeValue"))
            return core::fail(Error::Code::Corrupt,
                              file.name + " has a TimeValue that is not a finite number");
        if (value)
            out.*means = value;
    }
    return out;
}

} // namespace wakesurf::importer
