// A cache of finished downloads, counted in the memory account, and released before anything on display.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>

namespace wakesurf::server {

/// An immutable file; its memory is counted until the last reader releases it.
using File = std::shared_ptr<const std::string>;

/// Makes a file with the share of memory that counts it.
File counted_file(std::string bytes, core::MemoryAccount::Share share);

/// Caches files. Thread-safe.
class KeptFiles {
  public:
    /// @param account  null: memory is never reclaimed
    /// @param bytes    the limit for all files; the least recently used go first
    /// @param count    the same for their number
    KeptFiles(const core::MemoryAccount* account, std::size_t bytes, std::size_t count);

    /// Returns null if there is none with this tag.
    File find(const std::string& tag);

    void keep(const std::string& tag, File file);

    std::size_t bytes() const;

  private:
    struct Entry {
        std::string tag;
        File file;
    };

    struct State {
        mutable std::mutex mutex;
        std::list<Entry> entries; ///< most recently used first
        std::size_t bytes = 0;

        /// Removes the oldest and returns it, so that it is destroyed outside of the lock.
        File drop_last();
        void give_back(std::size_t wanted);
    };

    std::shared_ptr<State> state_ = std::make_shared<State>();
    std::size_t most_bytes_;
    std::size_t most_;
    std::shared_ptr<void> asked_; ///< the registration for reclaiming memory; destroyed first
};

} // namespace wakesurf::server
