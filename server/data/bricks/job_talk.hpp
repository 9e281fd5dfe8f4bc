// The server's side of the connection to a job that holds bricks. The job is not trusted: its identity is
// checked before it gets memory, and each brick after it is copied.
#pragma once

#include "core/base/result.hpp"
#include "server/base/private_file.hpp"
#include "server/data/bricks/job_message.hpp"
#include "server/data/bricks/shared_slots.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Describes the job that is accepted.
struct WantedJob {
    BrickShape shape;
    /// Says that values certainly differ from those with the job's marks: store::StoreReader::contradicts.
    std::function<bool(std::string_view marks)> contradicts;
    std::size_t slots = 16; ///< bricks that are requested at a time
    /// The wait for a rank; after it the rank gets no requests until it has answered.
    std::chrono::milliseconds patience{1000};
};

/// Talks to one job. One thread at a time.
class JobTalk {
  public:
    enum class Outcome {
        /// It is another brick, or differs from the file.
        Taken,
        NotHeld, ///< no rank has it, or not yet
        Damaged,
    };

    /// Reads a client's first message, and greets it. Empty if it has not come yet. Error: Corrupt for
    /// anything but such a job; InvalidArgument for one of another store, or of older values of the store.
    static core::Result<std::optional<JobTalk>> meet(OpenFile& guest, const WantedJob& wanted);

    int socket() const { return socket_.get(); }

    std::uint64_t ranks() const { return ranks_; }

    std::uint64_t held() const { return held_; }

    std::size_t free() const { return free_.size(); }

    /// Requests bricks, and returns the slot of each. Error: Io if the job is gone. REQUIRES: at most free().
    core::Result<std::vector<std::uint32_t>> ask(std::span<const BrickAsk> bricks);

    /// Returns the slots that the job has filled. Error: Io if it is gone; Corrupt for an impossible answer.
    core::Result<std::vector<std::uint32_t>> filled();

    /// Copies and frees a filled slot. REQUIRES: as many numbers as the shape's.
    Outcome take(std::uint32_t slot, std::span<float> to);

    /// Frees the slot of a brick that is no longer wanted.
    void drop(std::uint32_t slot) {
        asked_[slot].reset();
        free_.push_back(slot);
    }

  private:
    JobTalk(OpenFile socket, SharedSlots slots, const JobHello& hello);

    OpenFile socket_;
    SharedSlots slots_;
    std::uint64_t ranks_;
    std::uint64_t held_;
    std::vector<std::uint32_t> free_;
    std::vector<std::optional<BrickAsk>> asked_; ///< of each slot
};

} // namespace wakesurf::server
