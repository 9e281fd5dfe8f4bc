// Chunks of a Zarr that are unpacked, within a budget: a brick touches several, and its neighbours the same ones. Below server/service/zarr/zarr_disk.hpp.
#pragma once

#include "core/base/result.hpp"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::server {

/// Chunks that are used now and being read count as well: who needs more room than there is waits. Thread safety: concurrent calls are fine.
class ChunkCache {
  public:
    struct Name {
        std::size_t array = 0;   ///< which of the arrays
        std::uint64_t chunk = 0; ///< its number in the array
        auto operator<=>(const Name&) const = default;
    };

    using Bytes = std::vector<std::byte>;
    using Fetch = std::function<core::Result<Bytes>()>;
    using Use = std::function<void(std::span<const std::byte>)>;

    explicit ChunkCache(std::size_t budget) : budget_(budget) {}

    /// Not below what fetching any chunk takes.
    void resize(std::size_t budget);

    /// Calls `use` with the chunk, which one caller fetches for all who want it. Blocks. Error: of `fetch`; Cancelled where `stop` fires
    /// while it waits for others.
    /// @param room  what fetching takes, the chunk among it. REQUIRES: no more than the budget
    core::Result<void> with(const Name& name,
                            std::size_t room,
                            const Fetch& fetch,
                            const Use& use,
                            const std::stop_token& stop);

    /// Bytes of all chunks, and of the reading of others.
    std::size_t bytes() const;

  private:
    struct Entry {
        Bytes bytes;
        std::size_t users = 0;
        bool fetching = true;
        std::list<Name>::iterator age;
    };

    using Entries = std::map<Name, Entry>;

    /// What an entry takes beside its bytes.
    static constexpr std::size_t entry_bytes = 160;

    bool make_room(std::size_t room);
    core::Result<void> fetched(std::unique_lock<std::mutex>& lock,
                               const Name& name,
                               std::size_t room,
                               const Fetch& fetch);

    mutable std::mutex mutex_; ///< guards what follows; not held while a chunk is fetched or used
    std::condition_variable_any changed_;
    std::size_t budget_;
    std::size_t bytes_ = 0;
    Entries entries_;
    std::list<Name> ages_; ///< of those that are there, used last first
};

} // namespace wakesurf::server
