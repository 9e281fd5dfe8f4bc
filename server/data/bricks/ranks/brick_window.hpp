// The bricks of a store in the memory of all ranks: dealt round robin, read from the file by the rank that
// has them, fetched by rank 0 without that rank's participation (MPI_Rget).
#pragma once

#include "server/data/bricks/ranks/rank_store.hpp"

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::server {

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
