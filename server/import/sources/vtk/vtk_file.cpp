#include "server/import/sources/vtk/vtk_file.hpp"

#include "server/import/sources/files/file_names.hpp"
#include "server/import/sources/vtk/hdf_file.hpp"
#include "server/import/sources/vtk/legacy_file.hpp"
#include "server/import/sources/vtk/xml_file.hpp"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::server {

namespace {

constexpr std::array xml_extensions{".vti",  ".vtr",  ".vts",  ".vtu",  ".vtp",
                                    ".pvti", ".pvtr", ".pvts", ".pvtu", ".pvtp"};

bool is_xml(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return std::find(xml_extensions.begin(), xml_extensions.end(), extension) !=
           xml_extensions.end();
}

} // namespace

bool is_vtk_file(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return is_xml(path) || extension == ".vtk" || extension == ".vtm" || extension == ".vtmb" ||
           is_hdf(path);
}

core::Result<VtkFile> read_vtk_file(const ListedFile& file, const WantedArrays& wanted) {
    if (is_hdf(file.path))
        return read_hdf_file(file, wanted);
    return is_xml(file.path) ? read_xml_file(file, wanted) : read_legacy_file(file);
}

core::Result<std::optional<double>> vtk_file_time(const ListedFile& file) {
    if (is_xml(file.path))
        return xml_file_time(file);
    return read_vtk_file(file, {}).map([](const VtkFile& read) { return time_in(*read.data); });
}

core::Result<std::set<std::pair<core::FieldInfo::Source, std::string>>>
vtk_file_fields(const ListedFile& file) {
    if (is_xml(file.path))
        return xml_file_fields(file);
    return core::fail(core::Error::Code::Unsupported,
                      file.name + " has no header that lists its arrays");
}

std::optional<double> time_in(vtkDataObject& data) {
    for (const char* name : {"TimeValue", "TIME"})
        if (vtkDataArray* time = data.GetFieldData()->GetArray(name);
            time != nullptr && time->GetNumberOfValues() > 0 && std::isfinite(time->GetTuple1(0)))
            return time->GetTuple1(0);
    return std::nullopt;
}

} // namespace wakesurf::server
