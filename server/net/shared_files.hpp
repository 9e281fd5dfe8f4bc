// Files that several clients may request and that take long to make: made once for all of them, in turn with
// other computations, and cached while there is memory.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/base/loop.hpp"
#include "server/live/compute/compute_pool.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// An immutable file; its memory is counted until the last reader releases it.
using File = std::shared_ptr<const std::string>;

/// Makes and caches files, which are counted in the memory account, and released before anything on display.
/// Loop thread only; files are made in the pool.
class SharedFiles {
  public:
    /// Returns the bytes of a file; runs on a compute thread. It first grows `share` to the memory that they
    /// and making them take.
    using Make = std::function<core::Result<std::string>(const std::stop_token& stop,
                                                         core::MemoryAccount::Share& share)>;
    using Done = std::function<void(const core::Result<File>&)>;

    /// REQUIRES: all arguments outlive this. @param account  may be null
    SharedFiles(Loop& loop, ComputePool& pool, const core::MemoryAccount* account);

    /// Stops what is being made; callbacks are not called.
    ~SharedFiles();
    SharedFiles(const SharedFiles&) = delete;
    SharedFiles& operator=(const SharedFiles&) = delete;

    /// Calls `done` once, now or later, unless `gone` fires before, on this thread. A file is abandoned when
    /// no client waits for it.
    /// @param tag    the same tag, the same bytes
    /// @param asker  the key for taking turns: one long file of each key is made at a time
    /// @param priority  by how long making it takes
    void get(const std::string& tag,
             const std::string& asker,
             Make make,
             const std::stop_token& gone,
             Done done,
             PriorityClass priority = PriorityClass::Long);

    /// Returns the number of files that are being made or queued.
    std::size_t making() const;

  private:
    struct State;
    std::shared_ptr<State> state_;
};

} // namespace wakesurf::server
