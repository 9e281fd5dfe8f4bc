#include "importer/sources/vtk/xml_file.hpp"

#include "importer/base/vtk_messages.hpp"
#include "importer/sources/vtk/xml_array_sizes.hpp"
#include "importer/sources/vtk/xml_header.hpp"
#include "importer/sources/vtk/xml_time.hpp"

#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <map>
#include <new>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

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
    auto header = read_xml_header(file);
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

// VTK's readers of parallel files leave out what they cannot read of a piece, and say nothing.
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
        return core::fail(Error::Code::Corrupt, file.name + " is not what its type says it is");
    try {
        reader->UpdateInformation();
        if (auto clean = messages.verdict(file.name); !clean)
            return tl::unexpected(clean.error());
        select_arrays(*reader->GetPointDataArraySelection(), FieldInfo::Source::Point, wanted);
        select_arrays(*reader->GetCellDataArraySelection(), FieldInfo::Source::Cell, wanted);
        reader->Update();
        if (auto clean = messages.verdict(file.name); !clean)
            return tl::unexpected(clean.error());
    } catch (const std::bad_alloc&) {
        return core::fail(Error::Code::OverLimit,
                          "there is not enough memory to read " + file.name);
    }
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
    if (const auto header = checked_header(file); !header)
        return tl::unexpected(header.error());
    const VtkMessages messages;
    auto time = xml_time(file);
    if (auto clean = messages.verdict(file.name); !clean)
        return tl::unexpected(clean.error());
    return time;
}

core::Result<std::set<std::pair<FieldInfo::Source, std::string>>>
xml_file_fields(const ListedFile& file) {
    const VtkMessages messages;
    const auto header = read_xml_header(file);
    if (auto clean = messages.verdict(file.name); !clean)
        return tl::unexpected(clean.error());
    if (!header)
        return tl::unexpected(header.error());
    std::set<std::pair<FieldInfo::Source, std::string>> out;
    const auto add_arrays = [&](vtkXMLDataElement& parent) {
        for (const auto& [element, place] : {std::pair("PointData", FieldInfo::Source::Point),
                                             std::pair("CellData", FieldInfo::Source::Cell)})
            for (const char* const prefix : {"", "P"})
                if (auto* const data =
                        parent.FindNestedElementWithName((std::string(prefix) + element).c_str()))
                    for (int i = 0; i < data->GetNumberOfNestedElements(); ++i)
                        if (const char* name = data->GetNestedElement(i)->GetAttribute("Name"))
                            out.emplace(place, name);
    };
    add_arrays(*header->primary); // of a parallel file
    for (int i = 0; i < header->primary->GetNumberOfNestedElements(); ++i)
        add_arrays(*header->primary->GetNestedElement(i));
    return out;
}

} // namespace wakesurf::importer
