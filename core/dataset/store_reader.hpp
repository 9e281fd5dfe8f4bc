// Reads a store: the folder of raw float32 files that wakesurf-import and `wakesurf generate` write. First stage of the path;
// the manifest's text is read by protocol/store_manifest.hpp, which fills the layout.
#pragma once

#include "core/base/disk.hpp"
#include "core/dataset/time_step_source.hpp"

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

namespace wakesurf::core {

struct StoreLayout {
    std::filesystem::path folder;
    UniformGrid grid;
    std::vector<double> times;
    std::string mask; ///< file name inside the folder; empty: no obstacle
};

/// File of one time-step inside the folder: velocity_000000.f32 and so on.
std::string velocity_file_name(std::size_t index);

/// Bytes of such a file. Error: InvalidArgument for a grid thinner than 2 nodes, with non-finite or
/// non-positive spacing, or beyond the address space.
Result<std::size_t> velocity_file_size(const UniformGrid& grid);

/// A time-step counts as ready when its file exists with the right size, so a store can be read while it
/// is still being written. Thread safety: concurrent calls are fine.
class StoreReader final : public TimeStepSource {
  public:
    /// Error: InvalidArgument (grid or times make no sense), NotFound, Io, Corrupt (mask).
    static Result<std::shared_ptr<const StoreReader>> open(StoreLayout layout,
                                                           std::shared_ptr<const Disk> disk);

    const UniformGrid& grid() const override { return layout_.grid; }

    const SolidMask& mask() const override { return mask_; }

    const std::vector<double>& times() const override { return layout_.times; }

    bool ready(std::size_t index) const override;
    std::size_t bytes_per_step() const override;

    /// Corrupt: truncated, not finite, or another file than the one read under this name before.
    Result<std::shared_ptr<const TimeStep>> load(std::size_t index,
                                                 std::stop_token stop) const override;

  private:
    StoreReader(StoreLayout layout, std::shared_ptr<const Disk> disk, std::size_t file_size);
    Result<void> load_mask();
    Result<FileIdentity> whole_file(std::size_t index) const;
    Result<void> same_as_before(std::size_t index, const FileIdentity& identity) const;

    StoreLayout layout_;
    std::shared_ptr<const Disk> disk_;
    std::size_t file_size_;
    SolidMask mask_;
    mutable std::mutex mutex_; ///< guards seen_
    mutable std::vector<std::optional<FileIdentity>> seen_;
};

} // namespace wakesurf::core
