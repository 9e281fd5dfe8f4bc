// Reads that the ranks do not answer, made from files instead.
#pragma once

#include "server/data/bricks/waiting_read.hpp"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace wakesurf::server {

/// Makes reads. The destructor waits for pending ones. Thread safety: concurrent calls are allowed.
class ReadsFromFiles {
  public:
    /// REQUIRES: `files` outlives this.
    explicit ReadsFromFiles(const core::BrickSource& files) : files_(files) {}

    ~ReadsFromFiles();
    ReadsFromFiles(const ReadsFromFiles&) = delete;
    ReadsFromFiles& operator=(const ReadsFromFiles&) = delete;

    /// Begins reads, grouped by call, so that files read neighbours in one go.
    void begin(std::vector<WaitingRead> reads);

    /// Returns the number of reads begun so far.
    std::uint64_t count() const;

  private:
    const core::BrickSource& files_;
    mutable std::mutex mutex_;
    std::condition_variable none_left_;
    std::size_t left_ = 0; ///< guarded by the mutex, as what follows
    std::uint64_t count_ = 0;
};

} // namespace wakesurf::server
