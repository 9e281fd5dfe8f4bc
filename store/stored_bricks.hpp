// Bricks of a store's files, read and checked: in the calling thread, of which whole time-steps (store/store_reader.hpp) are made, or
// by a few threads, as the source below core/dataset/brick_cache.hpp where data are on a disk.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "core/base/worker_threads.hpp"
#include "core/dataset/brick_layout.hpp"
#include "core/dataset/brick_source.hpp"
#include "store/store_layout.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::store {

/// A brick is checked against its checksum when it is read for the first time, and again when its file is
/// another one than it was then. Memory: 6 bytes a brick of the files read last, up to 16 MiB, but of at least
/// 8 files. Thread safety: concurrent calls are fine.
class StoredBricks {
  public:
    /// Returns the record of a column at a time-step in checksums.u32. Error: NotFound while it is not ready,
    /// Corrupt where the store was replaced; to be read after the brick's name.
    using Expected =
        std::function<core::Result<std::uint32_t>(std::size_t column, std::size_t index)>;

    /// Called for each brick of a read, with its index there.
    using OnBrick = std::function<void(std::size_t which, core::Result<void> outcome)>;

    /// Opens the bricks. REQUIRES: check_layout(layout), and brick_cells is not 0.
    StoredBricks(StoreLayout layout, std::shared_ptr<const core::Disk> disk, Expected expected);

    const core::BrickLayout& layout() const { return bricks_; }

    std::size_t steps() const { return layout_.times.size(); }

    /// Returns how many there are, with those that were added.
    std::size_t columns() const;

    /// Adds a column that was made of others and is kept beside them, and returns its number. One that is
    /// there has the number that it had.
    std::size_t add(const KeptColumn& column) const;

    /// Returns the brick's place in the order of the file.
    std::size_t place_of(std::size_t brick) const { return bricks_.place_on_disk(brick); }

    /// Returns the brick that lies at a place.
    std::size_t brick_at(std::size_t place) const { return bricks_.brick_on_disk(place); }

    /// Returns the bytes that what is known of files takes at most.
    std::size_t memory() const;

    /// Returns the numbers of a brick.
    std::size_t values(std::size_t column) const {
        return bricks_.nodes_per_brick() * components_of(column);
    }

    /// Returns the bytes of a brick in its file.
    std::size_t stored_bytes(std::size_t column) const {
        return step_file_size(bricks_.nodes_per_brick(), components_of(column), precision(column));
    }

    /// Some values of a column at a time-step are not finite. Error: as of a brick.
    core::Result<bool> gaps(std::size_t column, std::size_t index) const;

    /// Reads neighbours in one go, from `place` on: each where `to` says, which has values(column) numbers.
    /// Error of a brick: NotFound, Io, Corrupt, Cancelled where the disk was slow and `stop` fired; naming
    /// it.
    void read(std::size_t column,
              std::size_t index,
              std::size_t place,
              std::span<const std::span<float>> to,
              const OnBrick& on_brick,
              const std::stop_token& stop = {}) const;

    /// Returns "brick 17 of time-step 3 (velocity_000003.f32)".
    std::string name_of(std::size_t column, std::size_t index, std::size_t brick) const;

  private:
    /// The facts about a file of bricks. The index belongs to the time-step; which bricks are checked, to the
    /// file.
    struct Known {
        BrickIndex index;
        core::FileIdentity file;
        /// The marks of checked bricks, by place; null without checksums.
        std::unique_ptr<std::atomic<bool>[]> checked;
    };

    using KnownFile = std::shared_ptr<const Known>;
    using Key = std::pair<std::size_t, std::size_t>; ///< time-step, column

    std::shared_ptr<const KeptColumn> kept(std::size_t column) const;
    std::vector<StepFile> files(std::size_t column, std::size_t index) const;
    core::Result<std::uint32_t> expected(std::size_t column, std::size_t index) const;

    core::Precision precision(std::size_t column) const {
        return column < layout_.columns() ? layout_.precision : core::Precision::Single;
    }

    core::Result<KnownFile> known(std::size_t column,
                                  std::size_t index,
                                  const std::optional<core::FileIdentity>& file) const;
    std::size_t most_recent() const;
    KnownFile recent(const Key& key, const std::optional<core::FileIdentity>& file) const;
    core::Result<KnownFile> examine(std::size_t column, std::size_t index) const;
    core::Result<void>
    check(std::size_t column, std::size_t index, std::uint32_t found, std::uint32_t written) const;

    StoreLayout layout_;
    std::shared_ptr<const core::Disk> disk_;
    Expected expected_;
    core::BrickLayout bricks_;
    /// Each guards a file: one thread reads its index for all.
    mutable std::array<std::mutex, 16> examining_;
    mutable std::mutex mutex_;                                    ///< guards what follows
    mutable std::vector<std::shared_ptr<const KeptColumn>> kept_; ///< never fewer
    mutable std::list<std::pair<Key, KnownFile>> recent_;         ///< used last first
};

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
    struct Request;

    bool there_is(const core::BrickRead& read) const;
    std::string name_of(const core::BrickRead& read) const;
    void read_run(const Request& request, std::size_t begin, std::size_t end, bool ending) const;

    const StoredBricks& bricks_;
    std::size_t readers_;
    mutable core::WorkerThreads threads_; ///< last: they use what is above
};

} // namespace wakesurf::store
