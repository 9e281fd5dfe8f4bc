// What the server and rank 0 of a job that holds bricks say to each other: by a Unix socket that keeps messages apart, on one machine, so
// the bytes of these structs are the messages. Bricks themselves lie in memory that both have (shared_slots.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace wakesurf::server {

inline constexpr std::uint32_t job_magic = 0x6b727742; ///< "Bwrk"
inline constexpr std::uint32_t job_version = 2;        ///< of these messages

/// What the bricks of a store are. Job and server must have the same.
struct BrickShape {
    std::array<std::uint32_t, 3> dimensions{}; ///< nodes an axis of the grid
    std::uint32_t cells = 0;                   ///< an axis of a brick
    std::uint64_t steps = 0;
    std::uint64_t values = 0; ///< numbers of a brick of velocity

    bool operator==(const BrickShape&) const = default;
};

/// First, from the job. store::ValueMarks::text() of the store follows it in the same message.
struct JobHello {
    std::uint32_t magic = job_magic;
    std::uint32_t version = job_version;
    BrickShape shape;
    std::uint64_t ranks = 0;
    std::uint64_t held = 0; ///< bricks for which the ranks have room
};

inline constexpr std::size_t longest_marks = 4096; ///< bytes of the text after JobHello

/// The answer, with the memory's descriptor. A job that is refused gets none: the socket closes.
struct ServerWelcome {
    std::uint32_t magic = job_magic;
    std::uint32_t slots = 0;
    std::uint64_t slot_bytes = 0;
    std::uint64_t patience =
        0; ///< milliseconds, after which a rank that has not answered is asked for nothing until it does
};

/// Then the server sends one or more of these in a message, each for a slot that is free, and gets the numbers of filled slots back
/// (uint32, one or more in a message) in any order.
struct BrickAsk {
    std::uint32_t slot = 0;
    std::uint32_t brick = 0;
    std::uint64_t step = 0;
};

/// What a brick begins with, in the memory of ranks and in slots; its numbers follow as floats.
struct BrickHead {
    std::uint32_t held = 0;     ///< job_magic, or the ranks do not have this brick
    std::uint32_t checksum = 0; ///< CRC-32C of the floats
    std::uint32_t brick = 0;
    std::uint32_t unused = 0;
    std::uint64_t step = 0;
    std::array<std::uint64_t, 5> padding{}; ///< a line of the processor's cache
};

static_assert(sizeof(BrickHead) == 64);

/// Of a slot, and of a brick in the memory of ranks.
constexpr std::size_t brick_record_bytes(std::uint64_t values) {
    return (sizeof(BrickHead) + static_cast<std::size_t>(values) * sizeof(float) + 63) / 64 * 64;
}

} // namespace wakesurf::server
