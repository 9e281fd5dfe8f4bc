#include "server/service/zarr/open_disk.hpp"

#include "core/base/folder_disk.hpp"
#include "server/service/web/dataset_disk.hpp"
#include "server/service/zarr/zarr_group.hpp"

#include <utility>

namespace wakesurf::server {

core::Result<OpenDisk> open_disk(const std::filesystem::path& folder,
                                 std::uint64_t scalar_bytes,
                                 std::stop_token closing) {
    auto disk = disk_of(folder, std::move(closing));
    if (!disk)
        return tl::unexpected(disk.error());
    if (!is_zarr(folder))
        return OpenDisk{std::move(*disk), nullptr};
    if (!is_on_the_web(folder)) // anybody's, unlike a store
        disk = std::make_shared<const core::FolderDisk>(folder);
    return ZarrDisk::open(folder, std::move(*disk), scalar_bytes)
        .map([](const std::shared_ptr<const ZarrDisk>& zarr) {
            return OpenDisk{zarr, zarr};
        });
}

bool is_others(const std::filesystem::path& folder) {
    return is_on_the_web(folder) || is_zarr(folder);
}

} // namespace wakesurf::server
