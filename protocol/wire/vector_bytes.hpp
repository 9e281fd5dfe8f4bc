// Points and vectors as three 64-bit numbers.
#pragma once

#include "core/base/vec3.hpp"
#include "protocol/wire/bytes.hpp"

namespace wakesurf::protocol {

inline void append_vector(Bytes& out, const core::Vec3& v) {
    for (int axis = 0; axis < 3; ++axis)
        append(out, v[axis]);
}

/// REQUIRES: offset + 24 <= bytes.size().
inline core::Vec3 vector_at(std::span<const std::byte> bytes, std::size_t offset) {
    return {number_at<double>(bytes, offset), number_at<double>(bytes, offset + 8),
            number_at<double>(bytes, offset + 16)};
}

} // namespace wakesurf::protocol
