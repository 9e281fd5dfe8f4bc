#include "store/open_store.hpp"

#include "store/store_manifest.hpp"

#include <utility>

namespace wakesurf::store {

core::Result<OpenStore> open_store(const std::filesystem::path& folder,
                                   std::shared_ptr<const core::Disk> disk,
                                   const std::function<core::Result<void>(std::uint64_t)>& room) {
    auto manifest = read_store_manifest(folder, *disk);
    if (!manifest)
        return tl::unexpected(manifest.error());
    StoreLayout layout = store_layout(*manifest, folder);
    if (auto sound = check_layout(layout); !sound)
        return tl::unexpected(sound.error());
    if (auto there = room ? room(opening_bytes(layout)) : core::Result<void>(); !there)
        return tl::unexpected(there.error());
    return StoreReader::open(std::move(layout), std::move(disk))
        .map([&](std::shared_ptr<const StoreReader> reader) {
            return OpenStore{std::move(manifest->info), std::move(reader)};
        });
}

} // namespace wakesurf::store
