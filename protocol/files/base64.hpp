// Bytes as text (RFC 4648).
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Appends the bytes in base64, with padding.
void append_base64(std::string& out, std::string_view bytes);

} // namespace wakesurf::protocol
