// The messages between the server and rank 0 of a job that holds bricks: by a Unix socket that preserves
// message boundaries, on one machine, so the bytes of these structs are the messages. Bricks themselves lie
// in shared memory (shared_slots.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace wakesurf::server {

inline constexpr std::uint32_t job_magic = 0x6b727742; ///< "Bwrk"
inline constexpr std::uint32_t job_version = 2;        ///< of these messages

/// Describes the bricks of a store. Job and server must have the same.
struct BrickShape {
    std::array<std::uint32_t, 3> dimensions{}; ///< nodes an axis of the grid
    std::uint32_t cells = 0;                   ///< an axis of a brick
    std::uint64_t steps = 0;
    std::uint64_t values = 0; ///< numbers of a brick of velocity

    bool operator==(const BrickShape&) const = default;
};

/// The job's first message. store::ValueMarks::text() of the store follows it in the same message.
struct JobHello {
    std::uint32_t magic = job_magic;
    std::uint32_t version = job_version;
    BrickShape shape;
    std::uint64_t ranks = 0;
    std::uint64_t held = 0; ///< bricks for which the ranks have memory
};

inline constexpr std::size_t longest_marks = 4096; ///< bytes of the text after JobHello

/// The answer, with the memory's descriptor. A refused job gets none: the socket closes.
struct ServerWelcome {
    std::uint32_t magic = job_magic;
    std::uint32_t slots = 0;
    std::uint64_t slot_bytes = 0;
    /// The time (ms) after which a rank that has not answered gets no requests until it does.
    std::uint64_t patience = 0;
};

/// The server then sends one or more of these in a message, each for a free slot, and receives the numbers of
/// filled slots (uint32, one or more in a message) in any order.
struct BrickAsk {
    std::uint32_t slot = 0;
    std::uint32_t brick = 0;
    std::uint64_t step = 0;
};

/// The header of a brick, in the memory of ranks and in slots; its numbers follow as floats.
struct BrickHead {
    std::uint32_t held = 0;     ///< job_magic, or the ranks do not have this brick
    std::uint32_t checksum = 0; ///< CRC-32C of the floats
    std::uint32_t brick = 0;
    std::uint32_t unused = 0;
    std::uint64_t step = 0;
    std::array<std::uint64_t, 5> padding{}; ///< a line of the processor's cache
};

static_assert(sizeof(BrickHead) == 64);

/// Returns the size of a slot, and of a brick in the memory of ranks.
constexpr std::size_t brick_record_bytes(std::uint64_t values) {
    return (sizeof(BrickHead) + static_cast<std::size_t>(values) * sizeof(float) + 63) / 64 * 64;
}

} // namespace wakesurf::server
