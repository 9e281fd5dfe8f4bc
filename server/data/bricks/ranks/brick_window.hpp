// The bricks of a store in the memory of all ranks: dealt round robin, read from the file by the rank that
// has them, fetched by rank 0 without that rank's participation (MPI_Rget).
#pragma once

#include "core/base/result.hpp"
#include "server/data/bricks/job_message.hpp"
#include "store/stored_bricks.hpp"
#include "store/value_marks.hpp"

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// A collective object: all ranks construct and destroy it together.
class BrickWindow {
  public:
    /// REQUIRES: the store outlives this, and a brick is smaller than 2 GiB, the bound of MPI's counts.
    /// @param memory  bytes of this rank
    BrickWindow(const RankStore& store, std::uint64_t memory);
    ~BrickWindow();
    BrickWindow(const BrickWindow&) = delete;
    BrickWindow& operator=(const BrickWindow&) = delete;

    /// Returns the number of bricks that fit into the memory of all ranks.
    std::uint64_t room() const { return room_; }

    /// Reads the next brick of this rank into its memory. Returns false after the last.
    bool load_next();

    /// Returns the rank of a brick; empty if it has none.
    std::optional<int> rank_of(std::uint64_t step, std::uint32_t brick) const;

    /// Begins to fetch a brick with its head to memory of brick_record_bytes(). The head of a brick that is
    /// not read yet says so; one that is being read has a wrong checksum. REQUIRES: a rank has room for it.
    MPI_Request get(std::uint64_t step, std::uint32_t brick, std::span<std::byte> to);

  private:
    const RankStore& store_;
    std::size_t record_;
    int rank_ = 0;
    int ranks_ = 1;
    std::vector<std::uint64_t> rooms_; ///< of each rank, in bricks
    std::uint64_t room_ = 0;
    std::uint64_t next_ = 0; ///< of this rank's
    std::byte* memory_ = nullptr;
    MPI_Win window_ = MPI_WIN_NULL;
};

} // namespace wakesurf::server
