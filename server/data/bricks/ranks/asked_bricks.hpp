// Rank 0: receives the server's requests by the socket, gets bricks from the ranks into the shared memory,
// and reports them.
#pragma once

#include "core/base/result.hpp"
#include "server/data/bricks/ranks/brick_window.hpp"
#include "server/data/bricks/shared_slots.hpp"

#include <chrono>
#include <filesystem>
#include <vector>

namespace wakesurf::server {

class AskedBricks {
  public:
    /// Connects to the server at `door`. Error: Io; the server is missing, or refuses this job.
    static core::Result<AskedBricks>
    meet(const std::filesystem::path& door, const RankStore& store, BrickWindow& window);

    /// Handles pending requests. Returns false if the server has gone, or asks for a brick that cannot exist.
    /// @param wait  for the server, if there is nothing else to do
    bool look(bool wait);

    /// Completes pending requests. Call it before the end.
    void finish();

  private:
    using Time = std::chrono::steady_clock::time_point;

    struct Coming {
        std::uint32_t slot;
        int rank; ///< the rank that has it
        Time since;
    };

    AskedBricks(OpenFile server, SharedSlots slots, const RankStore& store, BrickWindow& window)
        : server_(std::move(server)), slots_(std::move(slots)), store_(&store), window_(&window) {}

    bool take_asks();
    /// Says whether a rank's answer is overdue: it may hang, and the server has files.
    bool is_late(int rank, Time now) const;
    bool answer();

    OpenFile server_;
    SharedSlots slots_;
    const RankStore* store_;
    BrickWindow* window_;
    std::chrono::milliseconds patience_{};
    std::vector<MPI_Request> requests_;
    std::vector<Coming> coming_;        ///< of each request
    std::vector<std::uint32_t> filled_; ///< to be reported
};

} // namespace wakesurf::server
