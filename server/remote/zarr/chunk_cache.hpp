// A cache of unpacked chunks of a Zarr, within a budget: a brick touches several, and its neighbours the same
// ones. Below server/remote/zarr/zarr_disk.hpp.
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

/// Caches chunks. Chunks in use and being read count as well: a caller that needs more room than is free
/// waits. Thread safety: concurrent calls are allowed.
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

    /// Sets the budget. REQUIRES: it holds what fetching any chunk takes.
    void resize(std::size_t budget);

    /// Calls `use` with the chunk, which one caller fetches for all. Blocks. Error: of `fetch`; Cancelled if
    /// `stop` fires while it waits for others.
    /// @param room  the memory that fetching takes, the chunk included. REQUIRES: no more than the budget
    core::Result<void> with(const Name& name,
                            std::size_t room,
                            const Fetch& fetch,
                            const Use& use,
                            const std::stop_token& stop);

    /// Returns the memory of all chunks, and of reading others.
    std::size_t bytes() const;

  private:
    struct Entry {
        Bytes bytes;
        std::size_t users = 0;
        bool fetching = true;
        std::list<Name>::iterator age;
    };

    using Entries = std::map<Name, Entry>;

    /// The memory of an entry beside its bytes.
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
    std::list<Name> ages_; ///< of the cached chunks, most recently used first
};

} // namespace wakesurf::server
