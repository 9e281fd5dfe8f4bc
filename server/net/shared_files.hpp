// Files that many may ask for and that take long to make: made once for all who ask meanwhile, in turn with everything else that
// computes, kept while there is memory for them.
#pragma once

#include "core/base/result.hpp"
#include "server/net/kept_files.hpp"
#include "server/service/base/loop.hpp"
#include "server/service/compute/compute_pool.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Loop thread only; files are made in the pool.
class SharedFiles {
  public:
    /// On a compute thread: the bytes, having grown `share` to what they and making them take.
    using Make = std::function<core::Result<std::string>(const std::stop_token& stop,
                                                         core::MemoryAccount::Share& share)>;
    using Done = std::function<void(const core::Result<File>&)>;

    /// All outlive it. @param account  may be null
    SharedFiles(Loop& loop, ComputePool& pool, const core::MemoryAccount* account);

    /// Stops what is being made; no one is told.
    ~SharedFiles();
    SharedFiles(const SharedFiles&) = delete;
    SharedFiles& operator=(const SharedFiles&) = delete;

    /// Calls `done` once, now or later, unless `gone` fires before, on this thread. When all who wait for a file are gone it is
    /// made no further.
    /// @param tag    the same tag, the same bytes
    /// @param asker  takes turns with others: of one asker one file is made at a time
    void get(const std::string& tag,
             const std::string& asker,
             Make make,
             const std::stop_token& gone,
             Done done);

    /// How many are being made, or wait for their turn.
    std::size_t making() const;

  private:
    struct State;
    std::shared_ptr<State> state_;
};

} // namespace wakesurf::server
