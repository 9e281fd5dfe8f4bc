// The beginning of every .ply file, and its numbers.
#pragma once

#include "protocol/files/mesh_comments.hpp"

#include <bit>
#include <string>
#include <type_traits>

namespace wakesurf::protocol {

static_assert(std::endian::native == std::endian::little, "the file says binary_little_endian");

template <class T>
void put(std::string& out, T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Returns the head up to the first element.
inline std::string ply_head(const MeshMetadata& metadata) {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& line : mesh_comments(metadata))
        text += "comment " + line + "\n";
    return text;
}

} // namespace wakesurf::protocol
