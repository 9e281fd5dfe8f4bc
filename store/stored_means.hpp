// means.json: which time means of fields are kept beside a store's data, and in which files their values are:
// the mean, the rms and phase means. Their values lie as those of a time-step do, whole or in bricks, in
// single precision.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "core/dataset/mean_record.hpp"
#include "store/file_writing.hpp"
#include "store/kept_list.hpp"
#include "store/store_layout.hpp"
#include "store/value_marks.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

inline constexpr KeptList means_list{"means.json", "means", "mean_"};

/// A dataset has at most so many, each of one field.
inline constexpr std::size_t most_means = 64;
/// Of a mean: those of a velocity, with its components.
inline constexpr std::size_t most_fields = 9;
inline constexpr std::size_t most_phases = 64;

struct StoredMean {
    core::MeanRecord record;
    std::string stem;         ///< of its files: <stem>_FIELD_PHASE.f32
    std::uint32_t source = 0; ///< CRC-32C of the checksums of what was averaged
    /// Of each field: a checksum a phase, or one. Of a file in bricks that of its .bricks file.
    std::vector<std::vector<std::uint32_t>> sums;

    /// Returns its files of each field: one a phase, or one for all times.
    std::size_t files() const { return record.phases == 0 ? 1 : record.phases; }

    bool operator==(const StoredMean&) const = default;
};

/// Returns the scalars that a mean adds to a store, in the order of its fields.
std::vector<KeptColumn> columns_of(const StoredMean& mean, const std::vector<double>& times);

/// Returns the time-steps that count in a mean from a time to another.
std::vector<std::size_t> steps_between(const std::vector<double>& times, double from, double to);

/// Returns what tells the values that a mean is made of from others; nothing if not all are known.
/// @param column  of them
std::optional<std::uint32_t>
source_mark(const ValueMarks& now, std::span<const std::size_t> steps, std::size_t column);

/// All that are in the folder; none where the file is not there. Error: Io, Corrupt.
core::Result<std::vector<StoredMean>> read_means(const std::filesystem::path& folder,
                                                 const core::Disk& disk);

/// Returns those that were made of the present values.
std::vector<StoredMean>
current_means(std::vector<StoredMean> means, const StoreLayout& layout, const ValueMarks& now);

/// Writes a mean: its values file by file, then means.json with this one more, so that a reader sees it whole
/// or not at all, also after a power cut. No other program writes one meanwhile. What is not kept leaves
/// nothing; left-overs of one that was cut off go when the next begins.
class MeanWriter {
  public:
    /// Error: Io, where the folder cannot be written to or another program makes a field of it; Corrupt.
    static core::Result<MeanWriter> begin(const StoreLayout& layout, const ValueMarks& now);
    MeanWriter(MeanWriter&&) noexcept = default;
    MeanWriter& operator=(MeanWriter&&) = delete;
    ~MeanWriter();

    /// Returns the means that are there.
    const std::vector<StoredMean>& there() const { return there_; }

    /// Begins the next file of so many fields. Error: Io.
    core::Result<void> begin_files(std::size_t fields);

    /// Appends values to the file of a field: of the nodes, x fastest, or of whole bricks, in the order of the
    /// disk. Error: Io.
    core::Result<void> append(std::size_t field, std::span<const float> values);

    /// Error: Io.
    core::Result<void> end_files();

    /// Lists it. REQUIRES: its fields and files are those that were written. Error: OverLimit beyond
    /// most_means; Io.
    core::Result<void> keep(core::MeanRecord record, std::uint32_t source);

  private:
    struct Open {
        FolderChanges::File values;
        std::uint32_t sum = 0;
        std::size_t brick = 0; ///< the next, in the order of the disk
        std::optional<BrickIndex> bricks{};
    };

    MeanWriter(const StoreLayout& layout, FolderChanges changes)
        : layout_(layout), changes_(std::move(changes)) {}

    StoreLayout layout_;
    FolderChanges changes_;
    std::vector<StoredMean> before_, there_;
    StoredMean mean_;
    std::vector<std::string> written_; ///< files that go unless it is kept
    std::vector<Open> open_;           ///< one a field
    std::size_t next_ = 0;             ///< file
};

/// Removes the mean that has a field of this name, with all its fields. Error: NotFound, Io, Corrupt.
core::Result<void> remove_mean(const std::filesystem::path& folder, std::string_view name);

} // namespace wakesurf::store
