// The envelope of one binary message: a header, and a piece of an update. protocol/wire/FORMAT.md has the
// byte map. Twin: web-client/src/protocol/meshFrame.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"

#include <cstdint>
#include <span>

namespace wakesurf::protocol {

inline constexpr std::uint16_t frame_magic = 0x5357; ///< "WS" as bytes
inline constexpr std::uint8_t frame_version = 5;
inline constexpr std::size_t frame_header_bytes = 48;

// The largest frame that a reader accepts; a writer keeps its frames below 512 KiB.
inline constexpr std::size_t max_frame_bytes = 4u << 20;
inline constexpr std::uint32_t max_block_vertices = 1u << 16;
inline constexpr std::uint32_t max_mesh_vertices = 1u << 24;
inline constexpr std::uint32_t max_mesh_cells = 1u << 24;
inline constexpr std::uint8_t max_attributes = 8; ///< as many as `gaps` has bits

/// The quality of a state: how clients label it, and whether a better one follows.
enum class Phase : std::uint8_t { Coarse, Refined, Final, Live };

/// The header of every frame.
struct FrameHeader {
    /// The update starts from the empty state.
    static constexpr std::uint8_t key = 1;
    /// The state is the server's surface, exact on the lattice.
    static constexpr std::uint8_t lossless = 2;

    std::uint8_t flags = 0;    ///< `key` and `lossless`
    std::uint32_t surface = 0; ///< the subscription
    std::uint32_t epoch = 0;   ///< rises when the surface is another one
    std::uint32_t seq = 0;     ///< of the update; a DELTA starts from the state of the one before
    std::uint16_t frame_index = 0;    ///< of this frame in its update
    std::uint16_t frame_count = 1;    ///< of the update
    Phase phase = Phase::Final;       ///< of the state
    std::uint8_t lattice_bits = 16;   ///< of positions
    std::uint8_t attribute_count = 0; ///< of each vertex
    std::uint8_t gaps = 0;            ///< a bit an attribute: some vertices have no value of it
    std::uint32_t vertices = 0;       ///< of the state after the update
    std::uint32_t cells = 0;          ///< of the state after the update
    double time = 0.0;                ///< simulation time of the state
    std::uint32_t state_sum = 0;      ///< checksum of the state

    /// Says that the update needs no state before it.
    bool is_key() const { return (flags & key) != 0; }

    bool operator==(const FrameHeader&) const = default;
};

/// Says whether two frames can be of one update: equal but for their index.
bool same_update(FrameHeader a, const FrameHeader& b);

/// Holds a frame taken apart; the body points into the bytes that it was read from.
struct MeshFrame {
    FrameHeader header;              ///< read, or to be written
    std::span<const std::byte> body; ///< all behind the header
};

/// Returns the checksum of a frame's bytes, which stands in its header: CRC-32 as in zlib and PNG. REQUIRES:
/// at least frame_header_bytes.
std::uint32_t frame_crc(std::span<const std::byte> frame);

inline constexpr std::size_t frame_crc_at = 44;

/// Writes a frame and fills in its checksum.
Bytes write_frame(const MeshFrame& frame);

/// Reads a frame. Error: Unsupported for another version, OverLimit, Corrupt for anything else that is not a
/// whole, undamaged frame.
core::Result<MeshFrame> read_frame(std::span<const std::byte> bytes);

} // namespace wakesurf::protocol
