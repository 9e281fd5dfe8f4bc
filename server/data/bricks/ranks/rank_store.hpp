// The bricks of a store as a rank reads them: its files and their checksums, without the grid's arrays and
// masks, which no rank needs.
#pragma once

#include "core/base/result.hpp"
#include "server/data/bricks/job_message.hpp"
#include "store/stored_bricks.hpp"
#include "store/value_marks.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace wakesurf::server {

/// Reads bricks of the velocity.
class RankStore {
  public:
    /// Opens a store. Error: as read_store_manifest; Unsupported if the time-steps are whole.
    static core::Result<std::unique_ptr<RankStore>> open(const std::filesystem::path& folder);

    const BrickShape& shape() const { return shape_; }

    /// Returns the marks that identify its values.
    const std::string& marks() const { return marks_text_; }

    /// Counts the bricks of the series: one time-step after the other, in the order of the files.
    std::uint64_t bricks() const { return shape_.steps * bricks_.layout().count(); }

    bool has(std::uint64_t step, std::uint32_t brick) const {
        return step < shape_.steps && brick < bricks_.layout().count();
    }

    /// Returns the index of a brick among bricks(). REQUIRES: has() it.
    std::uint64_t place_of(std::uint64_t step, std::uint32_t brick) const {
        return step * bricks_.layout().count() + bricks_.place_of(brick);
    }

    /// Reads and checks a brick. Returns false if it is missing or damaged: the server then reads it, and
    /// reports the error.
    bool read(std::uint64_t place, std::span<float> to, BrickHead& head) const;

  private:
    RankStore(store::StoreLayout layout, store::ValueMarks marks);

    store::ValueMarks marks_;
    std::string marks_text_;
    store::StoredBricks bricks_;
    BrickShape shape_;
};

} // namespace wakesurf::server
