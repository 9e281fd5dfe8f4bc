#include "importer/sources/files/source_files.hpp"

#include "core/base/disk.hpp"
#include "importer/base/limited_rights.hpp"
#include "importer/base/reading_bounds.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <utility>

namespace wakesurf::importer {

namespace fs = std::filesystem;

namespace {

bool paths_are_confined = true;
std::vector<fs::path> refused;

fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path out = fs::weakly_canonical(path, error);
    return error ? fs::path() : out; // links in a circle
}

bool lies_below(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
}

// Its first bytes may stand behind others.
bool is_hdf5(const fs::path& file) {
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    constexpr std::streamoff farthest = std::streamoff{1} << 20;
    std::ifstream in(file, std::ios::binary);
    std::array<char, signature.size()> first{};
    for (std::streamoff at = 0; in && at <= farthest; at = at == 0 ? 512 : 2 * at) {
        in.seekg(at);
        if (in.read(first.data(), first.size()) &&
            std::string_view(first.data(), first.size()) == signature)
            return true;
    }
    return false;
}

} // namespace

void allow_paths_out_of_folder() {
    paths_are_confined = false;
}

void refuse_secrets(const std::vector<fs::path>& secrets) {
    refused = secrets;
}

std::string name_for_messages(const std::string& name) {
    return fs::path(name).is_absolute() ? fs::path(name).filename().string() : name;
}

core::Result<void> check_readable(const fs::path& path, const std::string& what) {
    const fs::path real = resolved(path);
    if (std::ranges::any_of(refused, [&](const auto& one) { return lies_below(real, one); }))
        return core::fail(core::Error::Code::Unsupported, what + ", which is private to the server",
                          "do not take this source from its author");
    if (paths_are_confined && is_hdf5(real) && !kernel_has_landlock())
        return core::fail(core::Error::Code::Unsupported,
                          what + ", which may link to other files: on this kernel, which has no "
                                 "Landlock, nothing keeps HDF5 from them",
                          "leave --confined out if you trust its author");
    return {};
}

core::Result<fs::path>
named_path(const fs::path& folder, const std::string& name, const std::string& named_by) {
    fs::path path = folder / name;
    const std::string what = named_by + " names " + fs::path(name).filename().string();
    if (paths_are_confined &&
        !lies_below(resolved(path), resolved(folder.empty() ? fs::path(".") : folder)))
        return core::fail(
            core::Error::Code::Unsupported, what + ", which lies outside of its folder",
            "put the files into one folder, without links that lead out of it, or leave "
            "--confined out if you trust its author");
    return check_readable(path, what).map([&] { return std::move(path); });
}

core::Result<void> check_links(const fs::path& folder, const std::string& named_by) {
    constexpr auto options = fs::directory_options::skip_permission_denied;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, options, error), end;
         !error && entry != end; entry.increment(error)) {
        made_progress();
        std::error_code ignored;
        if (!entry->is_symlink(ignored))
            continue;
        const auto name = entry->path().lexically_relative(folder).string();
        if (auto within = named_path(folder, name, named_by); !within)
            return tl::unexpected(within.error());
    }
    return {};
}

core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<NamedFile>& files) {
    std::vector<store::SourceFile> out;
    out.reserve(files.size());
    const core::PosixDisk disk;
    for (const auto& file : files) {
        const auto found = disk.identity(file.path);
        if (!found && found.error().code == core::Error::Code::NotFound)
            return core::fail(found.error().code, file.name + " is not there");
        if (!found)
            return tl::unexpected(found.error());
        out.push_back({file.name, found->size, found->modified});
    }
    return out;
}

} // namespace wakesurf::importer
