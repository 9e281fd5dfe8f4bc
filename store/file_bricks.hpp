// The bricks of a store's files, read by a few threads: the source below core/dataset/brick_cache.hpp where
// data are on a disk.
#pragma once

#include "core/base/worker_threads.hpp"
#include "core/dataset/brick_source.hpp"
#include "store/stored_bricks.hpp"

#include <cstddef>
#include <memory>

namespace wakesurf::store {

/// Reads that are neighbours in the file become one, of up to 2 MiB, as long as every thread has something to
/// do. Thread safety: concurrent calls are fine.
class FileBricks final : public core::BrickSource {
  public:
    /// @param bricks   lives as long as this
    /// @param threads  that read; they begin with the first read
    explicit FileBricks(const StoredBricks& bricks, std::size_t threads = 4)
        : bricks_(bricks), readers_(threads), threads_(threads) {}

    const core::BrickLayout& layout() const override { return bricks_.layout(); }

    /// True also where that cannot be read: reading its bricks says why.
    bool gaps(std::size_t step) const override { return bricks_.gaps(0, step).value_or(true); }

    void read(std::vector<core::BrickRead> reads, std::stop_token stop, Done done) const override;

  private:
    struct Asked;

    bool there_is(const core::BrickRead& read) const;
    std::string name_of(const core::BrickRead& read) const;
    void read_run(const Asked& asked, std::size_t begin, std::size_t end, bool ending) const;

    const StoredBricks& bricks_;
    std::size_t readers_;
    mutable core::WorkerThreads threads_; ///< last: they use what is above
};

} // namespace wakesurf::store
