#include "server/import/sources/vtk/xml_time.hpp"

#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkXMLDataParser.h>
#include <vtkZLibDataCompressor.h>

#include <cmath>
#include <fstream>
#include <string_view>

namespace wakesurf::server {

using core::Error;

namespace {

vtkXMLDataElement* time_element(vtkXMLDataElement& root) {
    const char* type = root.GetAttribute("type");
    auto* primary = type == nullptr ? nullptr : root.FindNestedElementWithName(type);
    auto* field = primary == nullptr ? nullptr : primary->FindNestedElementWithName("FieldData");
    return field == nullptr
               ? nullptr
               : field->FindNestedElementWithNameAndAttribute("DataArray", "Name", "TimeValue");
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

} // namespace

core::Result<std::optional<double>> xml_time(const ListedFile& file) {
    std::ifstream in(file.path, std::ios::binary);
    auto parser = vtkSmartPointer<vtkXMLDataParser>::New();
    parser->SetStream(&in);
    const bool parsed = parser->Parse() != 0;
    vtkXMLDataElement* root = parsed ? parser->GetRootElement() : nullptr;
    vtkXMLDataElement* array = root == nullptr ? nullptr : time_element(*root);
    if (array == nullptr)
        return std::optional<double>();
    set_compressor(*parser, *root);
    const char* type = array->GetAttribute("type");
    const auto time = type != nullptr && std::string_view(type) == "Float32"
                          ? first_value<float>(*parser, *array, VTK_FLOAT)
                          : first_value<double>(*parser, *array, VTK_DOUBLE);
    if (!time || !std::isfinite(*time) ||
        (type != nullptr && !std::string_view(type).starts_with("Float")))
        return core::fail(Error::Code::Corrupt,
                          file.name + " has a TimeValue that is not a finite number");
    return time;
}

} // namespace wakesurf::server
