// The server's side of the talk with a job that holds bricks. It trusts the job with nothing: who it is is checked before it is given
// memory, and each brick after it is copied.
#pragma once

#include "core/base/result.hpp"
#include "server/service/base/private_file.hpp"
#include "server/service/bricks/job_message.hpp"
#include "server/service/bricks/shared_slots.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// What a job has to be.
struct WantedJob {
    BrickShape shape;
    /// The values are certainly others than those that the job tells of: store::StoreReader::contradicts.
    std::function<bool(std::string_view marks)> contradicts;
    std::size_t slots = 16; ///< bricks that are on their way at a time
    /// With a rank; then the job asks it for nothing until it has answered.
    std::chrono::milliseconds patience{1000};
};

/// One thread at a time.
class JobTalk {
  public:
    enum class Outcome {
        Taken,
        NotHeld, ///< no rank has it, or not yet
        Damaged, ///< it is another brick, or not as it was read from the file
    };

    /// Hears who has come, and greets it. Nothing where it has not said so yet. Error: Corrupt, it is no such job; InvalidArgument, of
    /// another store, or of what the store was before.
    static core::Result<std::optional<JobTalk>> meet(OpenFile& guest, const WantedJob& wanted);

    int socket() const { return socket_.get(); }

    std::uint64_t ranks() const { return ranks_; }

    std::uint64_t held() const { return held_; }

    std::size_t free() const { return free_.size(); }

    /// Asks for bricks; the slot of each. Error: Io, the job is gone. REQUIRES: at most free().
    core::Result<std::vector<std::uint32_t>> ask(std::span<const BrickAsk> bricks);

    /// Slots that the job has filled. Error: Io, it is gone; Corrupt, it says what cannot be.
    core::Result<std::vector<std::uint32_t>> filled();

    /// Copies what is in a filled slot, which is free then. REQUIRES: as many numbers as the shape's.
    Outcome take(std::uint32_t slot, std::span<float> to);

    /// The same of a brick that no one waits for any more.
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
