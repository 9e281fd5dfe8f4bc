#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/files/bounded_xml.hpp"
#include "importer/sources/series/file_series.hpp"
#include "importer/sources/vtk/vtk_file.hpp"
#include "importer/sources/vtk/xml_header.hpp"

#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

// Checks that the arrays of a VTK XML file are stored with as many bytes as the file states elsewhere. VTK
// believes either: it reads the beginning of longer arrays, and divides by a block size that a flipped bit
// made zero.

std::uint64_t word_bytes(const std::string& type) {
    static const std::map<std::string_view, std::uint64_t> sizes{
        {"Int8", 1},   {"UInt8", 1}, {"Int16", 2},  {"UInt16", 2},  {"Int32", 4},
        {"UInt32", 4}, {"Int64", 8}, {"UInt64", 8}, {"Float32", 4}, {"Float64", 8}};
    const auto found = sizes.find(type);
    return found == sizes.end() ? 0 : found->second;
}

std::string decoded(std::string_view base64) {
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : base64) {
        const auto value = alphabet.find(c);
        if (value == std::string_view::npos)
            break;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count >= 8)
            out.push_back(static_cast<char>(bits >> (count -= 8) & 0xff));
    }
    return out;
}

// Counts nodes and cells of a piece; 0 if it does not state them.
struct Counts {
    std::uint64_t points = 0;
    std::uint64_t cells = 0;
    std::array<std::uint64_t, 3> axes{0, 0, 0};
};

Counts counts_of(vtkXMLDataElement& piece) {
    Counts out;
    std::array<int, 6> extent{};
    if (piece.GetVectorAttribute("Extent", 6, extent.data()) == 6) {
        out.points = out.cells = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto cells = static_cast<std::uint64_t>(
                std::max(std::int64_t{extent[2 * axis + 1]} - extent[2 * axis], std::int64_t{0}));
            out.axes[axis] = cells + 1;
            out.points *= cells + 1;
            out.cells *= std::max<std::uint64_t>(cells, 1);
        }
        return out;
    }
    vtkTypeInt64 count = 0;
    if (piece.GetScalarAttribute("NumberOfPoints", count) != 0)
        out.points = static_cast<std::uint64_t>(count);
    // A surface's piece counts its cells by kind.
    for (const char* kind :
         {"NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"})
        if (piece.GetScalarAttribute(kind, count) != 0)
            out.cells += static_cast<std::uint64_t>(count);
    return out;
}

class ArraySizes {
  public:
    ArraySizes(const ListedFile& file, const XmlHeader& header)
        : in_(file.path, std::ios::binary), name_(file.name), header_(header) {
        const auto type = xml_attribute(*header.root, "header_type");
        word_ = type == "UInt64" ? 8 : 4;
        big_ = xml_attribute(*header.root, "byte_order") == "BigEndian";
        compressed_ = header.root->GetAttribute("compressor") != nullptr;
        if (auto* appended = header.root->FindNestedElementWithName("AppendedData"))
            raw_ = xml_attribute(*appended, "encoding") == "raw";
    }

    core::Result<void> check() {
        for (int i = 0; i < header_.primary->GetNumberOfNestedElements(); ++i) {
            auto* element = header_.primary->GetNestedElement(i);
            const bool piece = std::string_view(element->GetName()) == "Piece";
            const auto counts = piece ? counts_of(*element) : Counts();
            const int groups = piece ? element->GetNumberOfNestedElements() : 1;
            for (int g = 0; g < groups; ++g)
                if (auto sound =
                        check_group(piece ? *element->GetNestedElement(g) : *element, counts);
                    !sound)
                    return sound;
        }
        return {};
    }

  private:
    core::Result<void> check_group(vtkXMLDataElement& group, const Counts& counts) {
        const std::string_view kind = group.GetName();
        std::size_t axis = 0;
        for (int i = 0; i < group.GetNumberOfNestedElements(); ++i) {
            auto& array = *group.GetNestedElement(i);
            if (std::string_view(array.GetName()) != "DataArray")
                continue;
            const auto name = xml_attribute(array, "Name");
            std::uint64_t tuples = 0;
            bool known = true;
            if (kind == "PointData" || kind == "Points")
                tuples = counts.points;
            else if (kind == "CellData" ||
                     (kind == "Cells" && (name == "offsets" || name == "types")))
                tuples = counts.cells;
            else if (kind == "Coordinates" && axis < 3)
                tuples = counts.axes[axis++];
            else
                known = false;
            vtkTypeInt64 components = 1;
            array.GetScalarAttribute("NumberOfComponents", components);
            const auto bytes = word_bytes(xml_attribute(array, "type"));
            known = known && bytes > 0 && components > 0;
            const auto wanted = tuples * static_cast<std::uint64_t>(components) * bytes;
            if (!sound(array, known ? std::optional(wanted) : std::nullopt))
                return core::fail(Error::Code::Corrupt,
                                  name_ +
                                      " is damaged: " + (name.empty() ? std::string(kind) : name) +
                                      " does not have the size that the file declares");
        }
        return {};
    }

    bool sound(vtkXMLDataElement& array, std::optional<std::uint64_t> wanted) {
        const auto format = xml_attribute(array, "format");
        vtkTypeInt64 offset = 0;
        std::string bytes;
        if (format == "appended") {
            if (array.GetScalarAttribute("offset", offset) == 0 || offset < 0)
                return false;
            const auto text = bytes_at(header_.appended + offset);
            bytes = raw_ ? text : decoded(text);
        } else if (format == "binary") {
            const auto text = bytes_at(array.GetXMLByteIndex(), 4096);
            const auto end = text.find('>');
            const auto begin = text.find_first_not_of(" \t\r\n", end + 1);
            if (end == std::string::npos || begin == std::string::npos)
                return false;
            bytes = decoded(std::string_view(text).substr(begin, longest));
        } else {
            return true;
        }
        const auto stored = stored_bytes(bytes);
        return stored && (!wanted || *stored == *wanted);
    }

    // Parses {bytes}, or {blocks, bytes of a block, bytes of the last one if it is shorter, ...}.
    std::optional<std::uint64_t> stored_bytes(const std::string& header) const {
        if (!compressed_)
            return word(header, 0);
        const auto blocks = word(header, 0), block = word(header, 1), last = word(header, 2);
        if (!blocks || (*blocks > 0 && (!block || !last || *block == 0 || *last > *block)))
            return std::nullopt;
        if (*blocks == 0)
            return 0;
        constexpr std::uint64_t most = std::uint64_t{1} << 56;
        if (*block > most / *blocks)
            return std::nullopt;
        return *last > 0 ? *block * (*blocks - 1) + *last : *block * *blocks;
    }

    std::optional<std::uint64_t> word(const std::string& bytes, std::size_t index) const {
        if (bytes.size() < (index + 1) * word_)
            return std::nullopt;
        std::uint64_t out = 0;
        for (std::size_t i = 0; i < word_; ++i) {
            const auto byte =
                static_cast<unsigned char>(bytes[index * word_ + (big_ ? i : word_ - 1 - i)]);
            out = out << 8 | byte;
        }
        return out;
    }

    std::string bytes_at(std::int64_t position, std::size_t count = longest) {
        std::string out(count, '\0');
        in_.clear();
        in_.seekg(position);
        in_.read(out.data(), static_cast<std::streamsize>(count));
        out.resize(static_cast<std::size_t>(in_.gcount()));
        return out;
    }

    static constexpr std::size_t longest = 32; // three words of 8 bytes, in base64

    std::ifstream in_;
    std::string name_;
    const XmlHeader& header_;
    std::size_t word_ = 4;
    bool big_ = false;
    bool compressed_ = false;
    bool raw_ = false;
};

// Checks the length that each array stored in binary begins with; VTK counts text arrays. Error: Corrupt,
// naming the array.
core::Result<void> check_array_sizes(const ListedFile& file, const XmlHeader& header) {
    return ArraySizes(file, header).check();
}

template <class Reader>
vtkSmartPointer<vtkXMLReader> make() {
    return vtkSmartPointer<Reader>::New();
}

vtkSmartPointer<vtkXMLReader> reader_of(const std::string& type) {
    using Make = vtkSmartPointer<vtkXMLReader> (*)();
    static const std::map<std::string, Make> readers{
        {"ImageData", make<vtkXMLImageDataReader>},
        {"RectilinearGrid", make<vtkXMLRectilinearGridReader>},
        {"StructuredGrid", make<vtkXMLStructuredGridReader>},
        {"UnstructuredGrid", make<vtkXMLUnstructuredGridReader>},
        {"PolyData", make<vtkXMLPolyDataReader>},
        {"PImageData", make<vtkXMLPImageDataReader>},
        {"PRectilinearGrid", make<vtkXMLPRectilinearGridReader>},
        {"PStructuredGrid", make<vtkXMLPStructuredGridReader>}};
    const auto found = readers.find(type);
    return found == readers.end() ? nullptr : found->second();
}

core::Result<XmlHeader> checked_header(const ListedFile& file) {
    const VtkMessages messages;
    auto header = read_xml_header(file, lower_extension(file.path).starts_with(".vtm"));
    if (auto clean = messages.verdict(file.name); !clean)
        return tl::unexpected(clean.error());
    if (!header)
        return header;
    if (auto sound = check_xml_header(*header, file.name); !sound)
        return tl::unexpected(sound.error());
    if (auto sound = check_array_sizes(file, *header); !sound)
        return tl::unexpected(sound.error());
    return header;
}

core::Result<VtkFile> load(const ListedFile& file, const WantedArrays& wanted);

// VTK's readers of parallel files leave out what they cannot read of a piece, without a message.
core::Result<void>
check_pieces(const ListedFile& file, vtkXMLDataElement& primary, const WantedArrays& wanted) {
    for (int i = 0; i < primary.GetNumberOfNestedElements(); ++i) {
        const char* source = primary.GetNestedElement(i)->GetAttribute("Source");
        if (source == nullptr)
            continue;
        const auto piece = load({file.path.parent_path() / source, source, {}}, wanted);
        if (!piece)
            return tl::unexpected(piece.error());
        if (auto whole = require_fields(*piece->data, wanted.fields, source); !whole)
            return whole;
    }
    return {};
}

core::Result<VtkFile> load(const ListedFile& file, const WantedArrays& wanted) {
    const auto header = checked_header(file);
    if (!header)
        return tl::unexpected(header.error());
    if (header->type.starts_with("P"))
        if (auto whole = check_pieces(file, *header->primary, wanted); !whole)
            return tl::unexpected(whole.error());
    const VtkMessages messages;
    const auto reader = reader_of(header->type);
    if (!reader)
        return core::fail(Error::Code::Unsupported,
                          file.name + " holds " + header->type + ", which is not a grid");
    reader->SetFileName(file.path.c_str());
    if (reader->CanReadFile(file.path.c_str()) == 0)
        return core::fail(Error::Code::Corrupt,
                          file.name + " is not of the type that its header names");
    const auto update = [&]() -> core::Result<void> {
        reader->UpdateInformation();
        if (auto clean = messages.verdict(file.name); !clean)
            return clean;
        select_arrays(*reader->GetPointDataArraySelection(), FieldInfo::Source::Point, wanted);
        select_arrays(*reader->GetCellDataArraySelection(), FieldInfo::Source::Cell, wanted);
        reader->Update();
        return messages.verdict(file.name);
    };
    if (auto clean = within_memory(file.name, update); !clean)
        return tl::unexpected(clean.error());
    vtkSmartPointer<vtkDataSet> data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
    if (data == nullptr)
        return core::fail(Error::Code::Corrupt, file.name + " holds no grid");
    return VtkFile{data, reader->GetClassName()};
}

} // namespace

core::Result<VtkFile> read_xml_file(const ListedFile& file, const WantedArrays& wanted) {
    return load(file, wanted);
}

core::Result<StatedTime> xml_file_time(const ListedFile& file) {
    const auto header = checked_header(file);
    if (!header)
        return tl::unexpected(header.error());
    if (header->cut)
        return StatedTime(); // it stands at the end
    const VtkMessages messages;
    auto time = xml_time(file);
    if (auto clean = messages.verdict(file.name); !clean)
        return tl::unexpected(clean.error());
    return time;
}

core::Result<std::vector<FieldInfo>> xml_file_fields(const ListedFile& file) {
    const VtkMessages messages;
    const auto header = read_xml_header(file);
    if (auto clean = messages.verdict(file.name); !clean)
        return tl::unexpected(clean.error());
    if (!header)
        return tl::unexpected(header.error());
    std::vector<FieldInfo> out;
    const auto add_arrays = [&](vtkXMLDataElement& parent) {
        for (const auto& [element, place] : {std::pair("PointData", FieldInfo::Source::Point),
                                             std::pair("CellData", FieldInfo::Source::Cell)})
            for (const char* const prefix : {"", "P"})
                if (auto* const data =
                        parent.FindNestedElementWithName((std::string(prefix) + element).c_str()))
                    for (int i = 0; i < data->GetNumberOfNestedElements(); ++i) {
                        int components = 1;
                        auto* const array = data->GetNestedElement(i);
                        array->GetScalarAttribute("NumberOfComponents", components);
                        if (const char* name = array->GetAttribute("Name"))
                            out.push_back({name, components, place, {}, {}});
                    }
    };
    add_arrays(*header->primary); // of a parallel file
    for (int i = 0; i < header->primary->GetNumberOfNestedElements(); ++i)
        add_arrays(*header->primary->GetNestedElement(i));
    return out;
}

} // namespace wakesurf::importer
