#include "server/remote/zarr/chunk_cache.hpp"

#include <iterator>
#include <new>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::Result;

void ChunkCache::resize(std::size_t budget) {
    const std::scoped_lock lock(mutex_);
    budget_ = budget;
    make_room(0);
    changed_.notify_all();
}

std::size_t ChunkCache::bytes() const {
    const std::scoped_lock lock(mutex_);
    return bytes_;
}

// Evicts the oldest unused chunks.
bool ChunkCache::make_room(std::size_t room) {
    for (auto age = ages_.end(); bytes_ + room > budget_ && age != ages_.begin();) {
        --age;
        const auto entry = entries_.find(*age);
        if (entry->second.users > 0)
            continue;
        bytes_ -= entry->second.bytes.capacity() + entry_bytes;
        age = ages_.erase(age);
        entries_.erase(entry);
    }
    return bytes_ + room <= budget_;
}

Result<void> ChunkCache::fetched(std::unique_lock<std::mutex>& lock,
                                 const Name& name,
                                 std::size_t room,
                                 const Fetch& fetch) {
    bytes_ += room;
    entries_[name]; // others wait for it
    lock.unlock();
    Result<Bytes> got;
    try {
        got = fetch();
    } catch (const std::bad_alloc&) {
        got = core::fail(Error::Code::OverLimit, "there is not enough memory to read it");
    }
    lock.lock();
    bytes_ -= room;
    changed_.notify_all();
    if (!got) {
        entries_.erase(name);
        return tl::unexpected(got.error());
    }
    Entry& entry = entries_[name];
    entry.bytes = std::move(*got);
    entry.fetching = false;
    entry.age = ages_.insert(ages_.begin(), name);
    bytes_ += entry.bytes.capacity() + entry_bytes;
    return {};
}

Result<void> ChunkCache::with(const Name& name,
                              std::size_t room,
                              const Fetch& fetch,
                              const Use& use,
                              const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    auto entry = entries_.find(name);
    while (entry == entries_.end() || entry->second.fetching) {
        if (stop.stop_requested())
            return core::fail(Error::Code::Cancelled, "reading it was cancelled");
        if (entry == entries_.end() && make_room(room)) {
            if (auto got = fetched(lock, name, room, fetch); !got)
                return got;
        } else {
            changed_.wait(lock, stop, [&] {
                const auto now = entries_.find(name);
                return now == entries_.end() ? make_room(room) : !now->second.fetching;
            });
        }
        entry = entries_.find(name);
    }
    Entry& chunk = entry->second;
    ++chunk.users;
    ages_.splice(ages_.begin(), ages_, chunk.age);
    lock.unlock();
    use(chunk.bytes);
    lock.lock();
    --chunk.users;
    changed_.notify_all();
    return {};
}

} // namespace wakesurf::server
