#include "importer/sources/vtk/vtk_file.hpp"

#include "importer/sources/files/file_names.hpp"
#include "importer/sources/vtk/composite_file.hpp"
#include "importer/sources/vtk/hdf_file.hpp"
#include "importer/sources/vtk/legacy_file.hpp"
#include "importer/sources/vtk/xml_file.hpp"
#include "importer/sources/vtk/xml_time.hpp"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::importer {

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

core::Result<StatedTime> vtk_file_time(const ListedFile& file) {
    if (is_xml(file.path) || names_others(file.path))
        return xml_file_time(file);
    return read_vtk_file(file, {}).map([&](const VtkFile& read) {
        StatedTime out;
        for (const auto& [name, means] : time_arrays)
            if (auto* array = read.data->GetFieldData()->GetArray(name);
                array != nullptr && array->GetNumberOfValues() > 0 &&
                std::isfinite(array->GetTuple1(0)))
                out.*means = array->GetTuple1(0);
        if (!out.time && lower_extension(file.path) == ".vtk")
            if ((out.time = legacy_title_time(file)))
                out.in_title = true;
        return out;
    });
}

core::Result<std::set<std::pair<core::FieldInfo::Source, std::string>>>
vtk_file_fields(const ListedFile& file) {
    if (is_xml(file.path))
        return xml_file_fields(file);
    return core::fail(core::Error::Code::Unsupported,
                      file.name + " has no header that lists its arrays");
}

} // namespace wakesurf::importer
