// Bytes as text (RFC 4648).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Appends the bytes in base64, with padding.
void append_base64(std::string& out, std::string_view bytes);

/// Says whether it is one of the letters, or the padding.
bool is_base64(char letter);

/// Returns the bytes of a text that append_base64 wrote; empty for any other.
std::optional<std::string> base64_bytes(std::string_view text);

} // namespace wakesurf::protocol
