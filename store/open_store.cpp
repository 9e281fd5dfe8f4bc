#include "store/open_store.hpp"

#include "store/store_manifest.hpp"

#include <utility>

namespace wakesurf::store {

core::Result<OpenStore> open_store(const std::filesystem::path& folder,
                                   std::shared_ptr<const core::Disk> disk) {
    auto manifest = read_store_manifest(folder, *disk);
    if (!manifest)
        return tl::unexpected(manifest.error());
    return StoreReader::open(store_layout(*manifest, folder), std::move(disk))
        .map([&](std::shared_ptr<const StoreReader> reader) {
            return OpenStore{std::move(manifest->info), std::move(reader)};
        });
}

} // namespace wakesurf::store
