// Which reader a path is for: by its extension and, where several formats share one, by what it holds.
#include "importer/sources/open_source.hpp"

#include "core/base/disk.hpp"
#include "importer/sources/cgns/cgns_source.hpp"
#include "importer/sources/ensight/ensight_source.hpp"
#include "importer/sources/exodus/exodus_source.hpp"
#include "importer/sources/files/file_names.hpp"
#include "importer/sources/netcdf/netcdf_source.hpp"
#include "importer/sources/openfoam/openfoam_source.hpp"
#include "importer/sources/plot3d/plot3d_source.hpp"
#include "importer/sources/series/folder_choice.hpp"
#include "importer/sources/series/numbered_files.hpp"
#include "importer/sources/vtk/vtk_files_source.hpp"

#include <array>
#include <fstream>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

struct Format {
    bool (*is_it)(const fs::path&);
    core::Result<std::unique_ptr<Source>> (*open)(const fs::path&, const command::SourceOptions&);
};

// .g is a grid of Exodus, which is NetCDF, or of Plot3D.
bool is_exodus_inside(const fs::path& path) {
    if (!is_exodus(path) || lower_extension(path) != ".g")
        return is_exodus(path);
    std::array<char, 4> start{};
    std::ifstream(path, std::ios::binary).read(start.data(), start.size());
    const std::string_view text(start.data(), start.size());
    return text.starts_with("CDF") || text == "\x89HDF";
}

constexpr std::array formats{
    Format{is_openfoam, open_openfoam},    Format{is_ensight, open_ensight},
    Format{is_exodus_inside, open_exodus}, Format{is_vtk_files, open_vtk_files},
    Format{is_netcdf, open_netcdf},        Format{is_cgns, open_cgns},
    Format{is_plot3d, open_plot3d}};

const Format* format_of(const fs::path& path) {
    for (const auto& format : formats)
        if (format.is_it(path))
            return &format;
    return nullptr;
}

} // namespace

core::Result<std::unique_ptr<Source>> open_source(const fs::path& path,
                                                  const command::SourceOptions& wish) {
    const std::string name = path.filename().string();
    std::error_code error;
    const Format* format = format_of(path);
    if (format == nullptr && fs::is_directory(path, error))
        return choose_in_folder(path,
                                [](const fs::path& file) { return format_of(file) != nullptr; })
            .and_then([&](const fs::path& chosen) { return open_source(chosen, wish); });
    if (!is_pattern(path) || fs::exists(path, error)) {
        const auto size = core::PosixDisk().size(path);
        if (!size && !fs::is_directory(path, error))
            return tl::unexpected(size.error());
        if (size && *size == 0 && !is_openfoam(path)) // a .foam only marks its folder
            return core::fail(Error::Code::Corrupt, name + " is empty");
    }
    if (format == nullptr)
        return core::fail(Error::Code::Unsupported, name + " is of a format that cannot be read",
                          "formats: OpenFOAM (case folder or .foam), EnSight (.case), Exodus (.e, "
                          ".exo), CGNS (.cgns), "
                          "NetCDF (.nc), Plot3D (.xyz, .x, .g, .q, .p3d), VTK (.vti, .vtr, .vts, "
                          ".vtu, their .pvt*, .vtm, "
                          ".vtk, .vtkhdf) and collections of it (.pvd, .series)");
    return format->open(path, wish);
}

} // namespace wakesurf::importer
