// Which reader a path is for: by its extension and, where several formats share one, by what it holds.
#include "core/base/disk.hpp"
#include "server/import/source.hpp"
#include "server/import/sources/cgns_source.hpp"
#include "server/import/sources/folder_choice.hpp"
#include "server/import/sources/netcdf_source.hpp"
#include "server/import/sources/numbered_files.hpp"
#include "server/import/sources/plot3d_source.hpp"
#include "server/import/sources/vtk_files_source.hpp"

#include <array>

namespace wakesurf::server {

using core::Error;
namespace fs = std::filesystem;

namespace {

struct Format {
    bool (*is_it)(const fs::path&);
    core::Result<std::unique_ptr<Source>> (*open)(const fs::path&);
};

constexpr std::array formats{Format{is_vtk_files, open_vtk_files}, Format{is_netcdf, open_netcdf},
                             Format{is_cgns, open_cgns}, Format{is_plot3d, open_plot3d}};

const Format* format_of(const fs::path& path) {
    for (const auto& format : formats)
        if (format.is_it(path))
            return &format;
    return nullptr;
}

} // namespace

core::Result<std::unique_ptr<Source>> open_source(const fs::path& path) {
    const std::string name = path.filename().string();
    std::error_code error;
    const Format* format = format_of(path);
    if (format == nullptr && fs::is_directory(path, error))
        return choose_in_folder(path,
                                [](const fs::path& file) { return format_of(file) != nullptr; })
            .and_then([](const fs::path& chosen) { return open_source(chosen); });
    if (!is_pattern(path) || fs::exists(path, error)) {
        const auto size = core::PosixDisk().size(path);
        if (!size && !fs::is_directory(path, error))
            return tl::unexpected(size.error());
        if (size && *size == 0)
            return core::fail(Error::Code::Corrupt, name + " is empty");
    }
    if (format == nullptr)
        return core::fail(Error::Code::Unsupported, name + " is of a format that cannot be read",
                          "formats: OpenFOAM (case folder, .foam), .pvd, .series, .vtm, .vti, "
                          ".vtr, .vts, .vtu and "
                          "their .pvt* forms, .vtk, .vtkhdf, EnSight (.case), Exodus (.e, .exo, "
                          ".ex2), CGNS (.cgns), "
                          "NetCDF (.nc), Plot3D (.xyz, .x, .g, .q, .p3d)");
    return format->open(path);
}

} // namespace wakesurf::server
