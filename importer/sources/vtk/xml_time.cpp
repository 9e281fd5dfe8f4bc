#include "importer/sources/vtk/xml_time.hpp"

#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkXMLDataParser.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

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
