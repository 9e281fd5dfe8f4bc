// Bricks from the memory of an MPI job's ranks, and from files if the ranks do not have them: the source
// below core/dataset/brick_cache.hpp if a job is started beside the server.
#pragma once

#include "core/dataset/brick_source.hpp"
#include "core/dataset/time_step_source.hpp"
#include "server/data/bricks/job_talk.hpp"
#include "server/data/bricks/rank_options.hpp"
#include "store/store_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

namespace wakesurf::server {

/// Reads bricks. A job that ends, hangs or is none costs no read: pending ones are made from files, and a new
/// job is started after a pause, which doubles until one connects again. Thread safety: concurrent calls are
/// allowed.
class RankBricks final : public core::BrickSource {
  public:
    using Options = RankOptions;
    using Duration = RankOptions::Duration;

    /// Describes the job and its work.
    struct Status {
        bool there = false;         ///< a job is
        std::uint64_t ranks = 0;    ///< of it
        std::uint64_t held = 0;     ///< bricks for which it has memory
        std::uint64_t jobs = 0;     ///< that have connected so far
        std::uint64_t by_ranks = 0; ///< bricks that ranks brought
        std::uint64_t by_files = 0; ///< that files did
        std::uint64_t damaged = 0;  ///< of these: with another checksum
    };

    /// @param files   outlives this. Velocities come from ranks, scalars always from files
    /// @param wanted  its slots bound the bricks that are requested at a time
    RankBricks(const core::BrickSource& files, WantedJob wanted, Options options);
    ~RankBricks() override;

    const core::BrickLayout& layout() const override { return files_.layout(); }

    bool gaps(std::size_t step) const override { return files_.gaps(step); }

    void read(std::vector<core::BrickRead> reads, std::stop_token stop, Done done) const override;

    Status status() const;

    /// Waits until so many jobs have connected, one after the other. Returns false after `most`.
    bool wait_for_job(std::uint64_t jobs, Duration most) const;

    /// Returns the memory that server and job share, once a job has connected.
    std::size_t shared_bytes() const;

    /// Starts jobs from now on. Before that all bricks come from files.
    void begin();

  private:
    struct State;

    const core::BrickSource& files_;
    std::unique_ptr<State> state_;
};

/// A store whose bricks may come from an MPI job: everything else is the reader's.
class RankedStore final : public core::TimeStepSource {
  public:
    /// REQUIRES: the store is in bricks.
    RankedStore(std::shared_ptr<const store::StoreReader> reader, RankBricks::Options options);

    const core::Grid& grid() const override { return reader_->grid(); }

    const core::SolidMask& mask() const override { return reader_->mask(); }

    const std::vector<double>& times() const override { return reader_->times(); }

    bool ready(std::size_t index) const override { return reader_->ready(index); }

    std::size_t bytes_per_step() const override { return reader_->bytes_per_step(); }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token stop) const override {
        return reader_->load(index, std::move(stop));
    }

    const core::BrickSource* bricks() const override { return &ranks_; }

    void release_memory() const override { reader_->release_memory(); }

    RankBricks& ranks() { return ranks_; }

    const RankBricks& ranks() const { return ranks_; }

  private:
    std::shared_ptr<const store::StoreReader> reader_;
    RankBricks ranks_; ///< destroyed first: it reads from the reader
};

} // namespace wakesurf::server
