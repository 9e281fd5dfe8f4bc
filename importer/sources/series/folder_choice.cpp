#include "importer/sources/series/folder_choice.hpp"

#include "importer/sources/files/file_names.hpp"
#include "importer/sources/series/numbered_files.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

bool lists_others(const fs::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".pvd" || extension == ".series" || extension == ".case" ||
           extension == ".foam" || extension == ".p3d";
}

// Files that are parts of others when those are there: pieces of .pvtu, blocks of .vtm, Plot3D solutions.
int rank(const fs::path& path) {
    const auto extension = lower_extension(path);
    if (lists_others(path))
        return 0;
    if (extension == ".vtm" || extension == ".vtmb" || extension.starts_with(".pvt"))
        return 1;
    return extension == ".q" ? 3 : 2;
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

} // namespace

core::Result<fs::path> choose_in_folder(const fs::path& folder,
                                        const std::function<bool(const fs::path&)>& readable) {
    const std::string name = (folder / "").parent_path().filename().string();
    auto files = files_in(folder);
    if (!files)
        return tl::unexpected(files.error());
    std::erase_if(*files, [&](const fs::path& file) { return !readable(file); });
    if (files->empty())
        return core::fail(Error::Code::NotFound, name + " holds nothing that can be read",
                          "give a folder with an OpenFOAM case, or with one series of files");
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
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(datasets.size(), most); ++i)
        list += (i == 0 ? "" : ", ") + datasets[i].filename().string();
    if (datasets.size() > most)
        list += ", ...";
    return core::fail(Error::Code::InvalidArgument, name + " holds several datasets: " + list,
                      "give one of them");
}

} // namespace wakesurf::importer
