// The identity of the values of a store: its grid and fields, then the times and checksums of its time-steps,
// in order. A series that grows keeps its earlier marks; one that was recomputed has others.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "store/store_layout.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

/// Checksums of a store's values, by which it is known again.
class ValueMarks {
  public:
    /// Reads the marks of the time-steps whose checksums are on the disk now; of none where there are no
    /// checksums yet. Error: Io.
    static core::Result<ValueMarks> read(const StoreLayout& layout, const core::Disk& disk);

    /// Time-steps that are known.
    std::size_t steps() const { return marks_.size() - 1; }

    /// Returns the checksum of a velocity (column 0) or a scalar. REQUIRES: index < steps().
    std::uint32_t checksum(std::size_t index, std::size_t column) const {
        return records_[index * columns_ + column];
    }

    /// The grid and the fields, the first time-step, and all that are known, for another time or place:
    /// "0-09c3f0a1b2c3d4e5 1-... 16-...".
    std::string text() const;

    /// Returns the mark of the grid and the fields alone.
    std::string shared_text() const { return word(0); }

    /// These are the values of `before`, and perhaps more time-steps after them.
    bool continues(const ValueMarks& before) const;

    /// Says whether some of these values certainly differ from those of text(). False for time-steps that are
    /// not known here.
    bool contradicts(std::string_view text) const;

  private:
    ValueMarks(const StoreLayout& layout, std::vector<std::uint32_t> records);

    std::string word(std::size_t steps) const;

    std::size_t columns_;
    std::vector<std::uint32_t> records_; ///< a time-step after the other
    std::vector<std::uint64_t> marks_;   ///< [n]: of the first n time-steps
};

} // namespace wakesurf::store
