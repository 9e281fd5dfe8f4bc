// The envelope of one binary message: header, attribute ranges, Draco points, cells code. protocol/README.md has the
// byte map. Twin: web-client/src/protocol/meshFrame.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/bytes.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

inline constexpr std::uint16_t frame_magic = 0x5357; ///< "WS" as bytes
inline constexpr std::uint8_t frame_version = 1;
inline constexpr std::size_t frame_header_bytes = 52;

// What a reader accepts; a writer stays well below (mesh_encoder.cpp).
inline constexpr std::size_t max_frame_bytes = 4u << 20;
inline constexpr std::uint32_t max_frame_vertices = 1u << 16;
inline constexpr std::uint32_t max_frame_cells = 1u << 18;
inline constexpr std::uint32_t max_mesh_vertices = 1u << 26;
inline constexpr std::uint32_t max_mesh_cells = 1u << 26;
inline constexpr std::uint8_t max_attributes = 16;

struct FrameHeader {
    static constexpr std::uint8_t first = 1; ///< a new mesh starts
    static constexpr std::uint8_t last = 2;  ///< the mesh is whole: check state_crc, show it
    static constexpr std::uint8_t final = 4; ///< no finer mesh of this epoch follows

    std::uint8_t flags = 0;
    std::uint32_t surface = 0; ///< the subscription
    std::uint32_t epoch = 0;
    std::uint32_t seq = 0; ///< counts the frames of an epoch
    std::uint32_t vertex_base = 0;
    std::uint32_t vertex_count = 0;
    std::uint32_t cell_base = 0;
    std::uint32_t cell_count = 0;
    std::uint8_t attribute_count = 0;
    std::uint8_t lattice_bits = 0;
    std::uint32_t draco_bytes = 0;
    std::uint32_t cell_bytes = 0;
    std::uint32_t state_crc = 0;

    bool operator==(const FrameHeader&) const = default;
};

/// What the 16 bit values 0 and 65535 of an attribute stand for, through the whole state.
struct AttributeRange {
    float lo = 0;
    float hi = 0;

    double value(std::uint16_t code) const;

    bool operator==(const AttributeRange&) const = default;
};

/// A frame taken apart; the blocks point into the bytes it was read from.
struct MeshFrame {
    FrameHeader header;
    std::vector<AttributeRange> ranges;
    std::span<const std::byte> draco;
    std::span<const std::byte> cells;
};

/// Fills in attribute_count and the byte counts from the blocks, and the checksum.
Bytes write_frame(const MeshFrame& frame);

/// Error: Unsupported for another version, OverLimit, Corrupt for anything else that is not a whole, undamaged frame.
core::Result<MeshFrame> read_frame(std::span<const std::byte> bytes);

} // namespace wakesurf::protocol
