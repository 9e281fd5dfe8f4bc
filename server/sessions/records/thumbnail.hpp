// The small picture of a session that a page sends for lists. Each editor may send it, so it is checked
// before it is kept: base64 of bytes that begin as a PNG, JPEG or WebP does, of at most a million pixels.
#pragma once

#include "core/base/result.hpp"

#include <string>
#include <string_view>

namespace wakesurf::server {

struct Thumbnail {
    std::string type; ///< image/png, image/jpeg or image/webp
    std::string bytes;
};

/// Error: InvalidArgument, OverLimit.
core::Result<Thumbnail> read_thumbnail(std::string_view base64);

} // namespace wakesurf::server
