// Finished downloads, kept for the next who asks: within the account of memory, and given back before anything that people look at.
#pragma once

#include "core/base/memory_account.hpp"

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>

namespace wakesurf::server {

/// Immutable; counted until the last reader has it.
using File = std::shared_ptr<const std::string>;

/// A file and the memory it is counted by.
File counted_file(std::string bytes, core::MemoryAccount::Share share);

/// Thread safety: all of it.
class KeptFiles {
  public:
    /// @param account  may be null: no one needs the memory back
    /// @param bytes    of all files together, and how many there may be; those not used for longest go
    KeptFiles(const core::MemoryAccount* account, std::size_t bytes, std::size_t count);

    /// Null where it is not kept.
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
        std::list<Entry> entries; ///< last used first
        std::size_t bytes = 0;

        /// Lets go of the oldest, and hands it out so that it ends without the lock.
        File drop_last();
        void give_back(std::size_t wanted);
    };

    std::shared_ptr<State> state_ = std::make_shared<State>();
    std::size_t most_bytes_;
    std::size_t most_;
    std::shared_ptr<void> asked_; ///< by those who need memory; ends first
};

} // namespace wakesurf::server
