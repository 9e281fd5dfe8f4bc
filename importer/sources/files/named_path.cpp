#include "importer/sources/files/named_path.hpp"

#include <algorithm>

namespace wakesurf::importer {

namespace fs = std::filesystem;

namespace {

bool paths_are_confined = true;

} // namespace

void allow_paths_out_of_folder() {
    paths_are_confined = false;
}

std::string told_name(const std::string& name) {
    return fs::path(name).is_absolute() ? fs::path(name).filename().string() : name;
}

core::Result<fs::path>
named_path(const fs::path& folder, const std::string& name, const std::string& named_by) {
    const fs::path path = folder / name;
    if (!paths_are_confined)
        return path;
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
    const fs::path real = error ? fs::path() : fs::weakly_canonical(path, error);
    const auto [left, rest] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
    if (error || left != root.end())
        return core::fail(
            core::Error::Code::Unsupported,
            named_by + " names " + fs::path(name).filename().string() +
                ", which lies outside of its folder",
            "put the files into one folder, without links that lead out of it, or leave "
            "--confined out if you trust its author");
    return path;
}

} // namespace wakesurf::importer
