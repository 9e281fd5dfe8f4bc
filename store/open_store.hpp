// A store by its folder: what it is, and its reader, from which a cache and a flow are made.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "store/store_reader.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

namespace wakesurf::store {

/// A store's description and its reader.
struct OpenStore {
    core::DatasetInfo info;                    ///< as its manifest has it
    std::shared_ptr<const StoreReader> reader; ///< never null
};

/// Opens a store, whole or still being written.
/// Error: as read_store_manifest and StoreReader::open; that of `room`.
/// @param room  asked for opening_bytes() before they are taken; empty: all there is
core::Result<OpenStore>
open_store(const std::filesystem::path& folder,
           std::shared_ptr<const core::Disk> disk = std::make_shared<core::PosixDisk>(),
           const std::function<core::Result<void>(std::uint64_t bytes)>& room = {});

} // namespace wakesurf::store
