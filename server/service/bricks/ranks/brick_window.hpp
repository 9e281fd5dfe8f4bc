// The bricks of a store in the memory of all ranks: dealt round robin, read from the file by the rank that has them, got by rank 0
// without that rank's doing (MPI_Rget).
#pragma once

#include "server/service/bricks/ranks/rank_store.hpp"

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::server {

/// All ranks make it together, and together end it.
class BrickWindow {
  public:
    /// @param store   outlives it
    /// @param memory  bytes of this rank. REQUIRES: a brick is smaller than 2 GiB, what MPI's counts hold.
    BrickWindow(const RankStore& store, std::uint64_t memory);
    ~BrickWindow();
    BrickWindow(const BrickWindow&) = delete;
    BrickWindow& operator=(const BrickWindow&) = delete;

    /// Bricks for which all ranks together have room.
    std::uint64_t room() const { return room_; }

    /// Reads the next brick of this rank into its memory. False when there are no more.
    bool load_next();

    /// Who has room for a brick, or nobody.
    std::optional<int> rank_of(std::uint64_t step, std::uint32_t brick) const;

    /// Begins to bring a brick with its head to memory of brick_record_bytes(). A brick that is not read yet comes with a head that says so,
    /// one that is being read with a checksum that does not fit. REQUIRES: a rank has room for it.
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
