// The bricks of a store as a rank reads them: its files and their checksums, without the grid's arrays and masks, which no rank needs.
#pragma once

#include "core/base/result.hpp"
#include "server/service/bricks/job_message.hpp"
#include "store/stored_bricks.hpp"
#include "store/value_marks.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace wakesurf::server {

/// The velocity's.
class RankStore {
  public:
    /// Error: as read_store_manifest; Unsupported where the time-steps are whole.
    static core::Result<std::unique_ptr<RankStore>> open(const std::filesystem::path& folder);

    const BrickShape& shape() const { return shape_; }

    /// What the values are told from others by.
    const std::string& marks() const { return marks_text_; }

    /// All of the series: a time-step after the other, as they lie in the files.
    std::uint64_t bricks() const { return shape_.steps * bricks_.layout().count(); }

    bool has(std::uint64_t step, std::uint32_t brick) const {
        return step < shape_.steps && brick < bricks_.layout().count();
    }

    /// Its place among bricks(). REQUIRES: has() it.
    std::uint64_t place_of(std::uint64_t step, std::uint32_t brick) const {
        return step * bricks_.layout().count() + bricks_.place_of(brick);
    }

    /// Reads and checks one. False where it is not there, or damaged: the server reads it then, and says what is wrong.
    bool read(std::uint64_t place, std::span<float> to, BrickHead& head) const;

  private:
    RankStore(store::StoreLayout layout, store::ValueMarks marks);

    store::ValueMarks marks_;
    std::string marks_text_;
    store::StoredBricks bricks_;
    BrickShape shape_;
};

} // namespace wakesurf::server
