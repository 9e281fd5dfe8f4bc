// Reads of bricks that wait for the job, and those that the files answer instead.
#pragma once

#include "core/dataset/brick_source.hpp"
#include "server/data/bricks/rank_options.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Holds the reads of one call.
struct AskedReads {
    std::vector<core::BrickRead> reads;
    std::stop_token stop;
    core::BrickSource::Done done;
};

/// Names one of them.
struct WaitingRead {
    std::shared_ptr<AskedReads> asked;
    std::size_t index = 0;

    const core::BrickRead& read() const { return asked->reads[index]; }

    void tell(core::Result<void> outcome) const { asked->done(index, std::move(outcome)); }

    /// Ends it without a brick.
    void cancel() const {
        tell(core::fail(core::Error::Code::Cancelled, "reading the brick was cancelled"));
    }
};

/// Holds the requests of one job. One thread at a time.
class ReadsOnTheirWay {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param options  patience, hung and clock; outlives this
    explicit ReadsOnTheirWay(const RankOptions& options) : options_(options) {}

    /// Adds requests. REQUIRES: as many slots as reads, none of them pending.
    void add(std::span<const std::uint32_t> slots, std::vector<WaitingRead> reads);

    /// Removes the request of a filled slot and returns its read; empty if it was late.
    std::optional<WaitingRead> take(std::uint32_t slot);

    /// Returns the reads that have waited too long, to be made from files. Their slots stay in use until the
    /// job answers.
    std::vector<WaitingRead> late();

    /// Says whether no read waits for the job: there is none, or all are late.
    bool nobody_waits() const;

    /// Says whether an answer is long overdue, despite other answers: a rank may hang.
    bool hung() const;

    /// Returns the next time at which late() or hung() may change if the job does not answer. Time::max():
    /// never.
    Time due() const;

    /// Returns the reads that still wait, and removes all requests.
    std::vector<WaitingRead> end();

  private:
    struct OnItsWay {
        /// The read; empty once files make it.
        std::optional<WaitingRead> read;
        Time since;
    };

    const RankOptions& options_;
    std::map<std::uint32_t, OnItsWay> by_slot_;
};

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
