#include "server/remote/remote_dataset.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace wakesurf::server {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 4> metadata_files{".zmetadata", ".zgroup", ".zarray",
                                                    "zarr.json"};

} // namespace

bool is_zarr(const fs::path& folder) {
    const bool named = std::any_of(folder.begin(), folder.end(), [](const fs::path& part) {
        return part.extension() == ".zarr";
    });
    if (named || is_on_the_web(folder))
        return named;
    return std::ranges::any_of(metadata_files, [&](const char* name) {
        std::error_code none;
        return fs::exists(folder / name, none);
    });
}

bool is_others(const fs::path& folder) {
    return is_on_the_web(folder) || is_zarr(folder);
}

core::Result<OpenDisk>
open_disk(const fs::path& folder, std::uint64_t scalar_bytes, std::stop_token closing) {
    if (!is_others(folder))
        return OpenDisk{std::make_shared<const core::PosixDisk>(), std::nullopt};
    return open_remote(folder, scalar_bytes, std::move(closing));
}

} // namespace wakesurf::server
