// Rank 0: takes what the server asks for by the socket, gets it from the ranks into the memory that both share, and says so.
#pragma once

#include "core/base/result.hpp"
#include "server/service/bricks/ranks/brick_window.hpp"
#include "server/service/bricks/shared_slots.hpp"

#include <chrono>
#include <filesystem>
#include <vector>

namespace wakesurf::server {

class AskedBricks {
  public:
    /// Meets the server at `door`. Error: Io; it is not there, or wants no such job.
    static core::Result<AskedBricks>
    meet(const std::filesystem::path& door, const RankStore& store, BrickWindow& window);

    /// Does what there is to do. False when the server has gone, or asks for what there cannot be.
    /// @param wait  for the server, where nothing else is to be done
    bool look(bool wait);

    /// Waits for what is under way. Before its end.
    void finish();

  private:
    using Time = std::chrono::steady_clock::time_point;

    struct Coming {
        std::uint32_t slot;
        int rank; ///< who has it
        Time since;
    };

    AskedBricks(OpenFile server, SharedSlots slots, const RankStore& store, BrickWindow& window)
        : server_(std::move(server)), slots_(std::move(slots)), store_(&store), window_(&window) {}

    bool take_asks();
    /// Owes an answer for too long: it may hang, and the server has files.
    bool is_late(int rank, Time now) const;
    bool answer();

    OpenFile server_;
    SharedSlots slots_;
    const RankStore* store_;
    BrickWindow* window_;
    std::chrono::milliseconds patience_{};
    std::vector<MPI_Request> requests_;
    std::vector<Coming> coming_;        ///< of each request
    std::vector<std::uint32_t> filled_; ///< to be told
};

} // namespace wakesurf::server
