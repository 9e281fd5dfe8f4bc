// Chooses the reader of a path: by its extension and, where that tells none or several formats share it, by what
// it holds.
#include "importer/sources/open_source.hpp"

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "importer/sources/files/file_names.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/other_formats.hpp"
#include "importer/sources/series/numbered_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

// Finds the one dataset in a folder that is given as a source.

bool lists_others(const fs::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".pvd" || extension == ".series" || extension == ".case" ||
           extension == ".foam" || extension == ".p3d";
}

// Ranks files that are parts of others when those are there: pieces of .pvtu, blocks of .vtm, Plot3D
// solutions, restarts and further pieces of Exodus.
int rank(const fs::path& path) {
    const auto extension = lower_extension(path);
    if (lists_others(path))
        return 0;
    if (extension == ".vtm" || extension == ".vtmb" || extension.starts_with(".pvt"))
        return 1;
    return extension == ".q" || continues_exodus(path) ? 3 : 2;
}

core::Result<std::vector<fs::path>> files_in(const fs::path& folder) {
    std::vector<fs::path> out;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        out.push_back(entry->path());
    if (error)
        return core::fail(Error::Code::Io,
                          folder.filename().string() + " cannot be listed: " + error.message());
    std::sort(out.begin(), out.end());
    return out;
}

// Returns a file that lists others (.pvd, .series, .case) before the files it may list; else the one file or
// numbered series there is. Only files that `readable` accepts count. Error: NotFound (nothing to read),
// InvalidArgument (several datasets, listed), Io.
core::Result<fs::path> choose_in_folder(const fs::path& folder,
                                        const std::function<bool(const fs::path&)>& readable) {
    constexpr std::size_t most = 8;
    const std::string name = (folder / "").parent_path().filename().string();
    auto files = files_in(folder);
    if (!files)
        return tl::unexpected(files.error());
    std::erase_if(*files, [&](const fs::path& file) { return !readable(file); });
    if (files->empty()) {
        const auto all = files_in(folder);
        for (std::size_t i = 0; all && i < std::min(all->size(), most); ++i)
            if (auto other = other_format((*all)[i]))
                return core::fail(Error::Code::NotFound,
                                  name + " holds nothing that can be read: " + other->message,
                                  other->hint);
        return core::fail(Error::Code::NotFound, name + " holds nothing that can be read",
                          "give a folder with an OpenFOAM case, or with one series of files");
    }
    const auto best =
        std::min_element(files->begin(), files->end(),
                         [](const auto& a, const auto& b) { return rank(a) < rank(b); });
    const int wanted = rank(*best);
    std::vector<fs::path> datasets; // one file of each
    std::set<fs::path> known;
    for (const auto& file : *files) {
        if (rank(file) != wanted || known.contains(file))
            continue;
        datasets.push_back(file);
        if (wanted == 0)
            continue;
        const auto series = numbered_files(file);
        if (!series)
            return tl::unexpected(series.error());
        known.insert(series->files.begin(), series->files.end());
    }
    if (datasets.size() == 1)
        return datasets.front();
    std::string list;
    for (std::size_t i = 0; i < std::min(datasets.size(), most); ++i)
        list += (i == 0 ? "" : ", ") + datasets[i].filename().string();
    if (datasets.size() > most)
        list += ", ...";
    return core::fail(Error::Code::InvalidArgument, name + " holds several datasets: " + list,
                      "give one of them");
}

struct Format {
    bool (*is_it)(const fs::path&);
    Opened (*open)(const fs::path&, const command::SourceOptions&);
};

constexpr std::array formats{
    Format{is_openfoam, open_openfoam}, Format{is_ensight, open_ensight},
    Format{is_exodus, open_exodus},     Format{is_vtk_files, open_vtk_files},
    Format{is_netcdf, open_netcdf},     Format{is_cgns, open_cgns},
    Format{is_plot3d, open_plot3d}};

const Format* format_of(const fs::path& path) {
    for (const auto& format : formats)
        if (format.is_it(path))
            return &format;
    return nullptr;
}

// Opens a file by what it holds, whatever it is called.
Opened open_held(Held held, const fs::path& path, const command::SourceOptions& wish) {
    return held == Held::Netcdf ? open_netcdf(path, wish) : open_cgns(path, wish);
}

} // namespace

core::Result<std::unique_ptr<Source>> open_source(const fs::path& path,
                                                  const command::SourceOptions& wish) {
    const std::string name = path.filename().string();
    std::error_code error;
    const Format* format = format_of(path);
    if (format == nullptr && fs::is_directory(path, error)) {
        if (auto other = other_format(path))
            return tl::unexpected(*other);
        auto chosen =
            choose_in_folder(path, [](const fs::path& file) { return format_of(file) != nullptr; });
        if (!chosen && chosen.error().code == Error::Code::NotFound)
            if (auto held = choose_in_folder(
                    path, [](const fs::path& file) { return held_format(file).has_value(); });
                held || held.error().code != Error::Code::NotFound)
                chosen = std::move(held);
        return chosen.and_then([&](const fs::path& file) { return open_source(file, wish); });
    }
    if (!is_pattern(path) || fs::exists(path, error)) {
        const auto size = core::PosixDisk().size(path);
        if (!size && !fs::is_directory(path, error))
            return tl::unexpected(size.error());
        if (size && *size == 0 && !is_openfoam(path)) // a .foam only marks its folder
            return core::fail(Error::Code::Corrupt, name + " is empty");
    }
    if (format == nullptr || is_plot3d(path) || lower_extension(path) == ".hdf")
        if (const auto held = held_format(path))
            return open_held(*held, path, wish);
    // Plot3D's files begin with any bytes.
    if (!is_plot3d(path))
        if (const auto other = other_format(path, format != nullptr))
            return tl::unexpected(*other);
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
