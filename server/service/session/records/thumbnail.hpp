// The small picture of a session that a page sends for lists. It comes from anybody who may edit, so it is
// looked at before it is kept: base64 of bytes that begin as a PNG, JPEG or WebP does, of at most a million
// pixels.
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
