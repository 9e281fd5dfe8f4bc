// The common part of .vtp files of a mesh and of lines on it: the head, which describes the surface, and
// arrays.
#pragma once

#include "protocol/files/mesh_metadata.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Returns the file up to its `<Piece`.
std::string vtp_head(const MeshMetadata& metadata);

/// Returns the file after its `</Piece>`.
std::string_view vtp_tail();

struct VtpCounts {
    std::size_t points = 0, lines = 0, polygons = 0;
};

std::string vtp_piece(const VtpCounts& counts);

/// Appends an array as `<DataArray>`.
/// @param type   `Float64`, `Int64`, ...
/// @param bytes  of its values, little-endian
void append_vtp_array(std::string& xml,
                      std::string_view type,
                      std::string_view name,
                      std::span<const std::byte> bytes,
                      int components = 1);

} // namespace wakesurf::protocol
