// Reads a store: the folder of raw files that wakesurf-import and `wakesurf generate` write. First stage of
// the path; the manifest's text is read by store/store_manifest.hpp, which fills the layout.
#pragma once

#include "core/base/disk.hpp"
#include "core/dataset/scalar_steps.hpp"
#include "core/dataset/slab.hpp"
#include "core/dataset/time_step_source.hpp"
#include "core/dataset/wall_geometry.hpp"
#include "store/store_layout.hpp"
#include "store/value_marks.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

class FileBricks;
class StoredBricks;

/// A time-step counts as ready when its checksums are there, which are written last: a store can be read
/// while it is still being written. A file is checked against its checksum when it is read for the first
/// time, and again when it is another file than it was then; of a file in bricks, each of them. Checksums
/// that were seen once stay: values of another series that takes this one's place are never read as this
/// one's. Thread safety: concurrent calls are fine.
class StoreReader final : public core::TimeStepSource, public core::ScalarSource {
  public:
    /// Reads the grid and the mask. Error: InvalidArgument (grid or times make no sense), NotFound, Io,
    /// Corrupt.
    /// @param brick_threads  that read for bricks(), 0: as many as the disk likes; they begin when the first
    ///                       brick is asked for
    static core::Result<std::shared_ptr<const StoreReader>>
    open(StoreLayout layout, std::shared_ptr<const core::Disk> disk, std::size_t brick_threads = 0);
    ~StoreReader() override;

    /// Returns the grid as the source had it.
    const core::Grid& grid() const override { return grid_; }

    const core::SolidMask& mask() const override { return mask_; }

    core::PeriodicAxes periodic() const override { return layout_.grid.periodic; }

    const std::vector<double>& times() const override { return layout_.times; }

    /// Returns the layout of the files it reads.
    const StoreLayout& layout() const { return layout_; }

    /// Returns the disk of its files.
    const std::shared_ptr<const core::Disk>& disk() const { return disk_; }

    bool ready(std::size_t index) const override;

    /// Says whether the step is ready, and all its files exist with the right sizes; does not read their
    /// bytes.
    bool whole(std::size_t index) const;
    std::size_t bytes_per_step() const override;

    /// Returns the marks that identify its values, as far as they are known: see refresh().
    ValueMarks marks() const;

    /// Returns their ValueMarks::text.
    std::string values() const;
    /// Calls ValueMarks::contradicts.
    bool contradicts(std::string_view values) const;

    /// Learns the checksums that have come. False where those known are others by now: the store was
    /// replaced. Error: Io.
    core::Result<bool> refresh() const;

    /// Loads a time-step. Corrupt: truncated, another checksum, or the store was replaced.
    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token stop) const override;

    /// Returns the source of a store in bricks. load() and load_scalar() read all of them there.
    const core::BrickSource* bricks() const override;

    void release_memory() const override { slabs_->clear(); }

    /// Loads a scalar at a time-step, one float a node. Error: that of load.
    core::Result<core::Slab>
    load_scalar(std::size_t scalar, std::size_t index, const std::stop_token& stop) const;

    /// Returns a scalar from memory if it was asked for lately. Two time-steps each of at most 4 scalars are
    /// kept.
    core::Result<std::shared_ptr<const core::Slab>> scalar_values(
        std::size_t scalar, std::size_t index, const std::stop_token& stop) const override;

    std::optional<std::size_t> brick_field(std::size_t scalar) const override {
        return bricks_ == nullptr ? std::nullopt : std::optional(1 + scalar);
    }

    /// Returns the scalar's number here of a column that was made of the data and is kept beside them, in a
    /// store in bricks; for load_scalar and brick_field. Nothing where time-steps are whole.
    std::optional<std::size_t> add(const KeptColumn& column) const;

    /// Returns the bytes that scalar_values keeps at most.
    std::size_t scalar_memory() const;

    /// Returns the bytes that it keeps at most to check bricks: StoredBricks::memory.
    std::size_t brick_memory() const;

    /// Empty where the store has none. Error: NotFound, Io, Corrupt.
    core::Result<core::WallGeometry> load_walls() const;

  private:
    /// The facts about a file of a time-step since it was checked.
    struct Seen {
        core::FileIdentity identity;
        bool gaps = false;
    };

    StoreReader(StoreLayout layout, std::shared_ptr<const core::Disk> disk, ValueMarks marks);
    core::Result<void> load_mask();
    void open_bricks(std::size_t threads);

    std::size_t columns() const { return layout_.columns(); }

    core::Result<core::FileIdentity> whole_file(std::size_t column, std::size_t index) const;
    /// @return true if some values are not finite. @param out  as large as the values are as floats
    core::Result<bool> read(std::size_t column,
                            std::size_t index,
                            std::span<std::byte> out,
                            const std::stop_token& stop) const;
    core::Result<bool> read_bricks(std::size_t column,
                                   std::size_t index,
                                   std::span<std::byte> out,
                                   const std::stop_token& stop) const;
    core::Result<std::uint32_t> checksum(std::size_t column, std::size_t index) const;
    std::optional<Seen> seen(std::size_t column, std::size_t index) const;
    std::string file_name(std::size_t column, std::size_t index) const;

    StoreLayout layout_;
    std::shared_ptr<const core::Disk> disk_;
    std::size_t nodes_;
    core::Grid grid_;
    core::SolidMask mask_;
    std::shared_ptr<core::SlabPool> slabs_; ///< for velocities; time-steps give theirs back
    std::unique_ptr<core::ScalarSteps> scalars_;
    mutable std::mutex mutex_;                      ///< guards seen_ and marks_
    mutable std::vector<std::optional<Seen>> seen_; ///< by time-step, then column
    mutable ValueMarks marks_;
    std::unique_ptr<const StoredBricks> stored_bricks_; ///< null where time-steps are whole
    std::unique_ptr<const FileBricks> bricks_; ///< destroyed first: its threads use the others
};

} // namespace wakesurf::store
