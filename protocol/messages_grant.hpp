// A share link as it is kept: the role it gives, the digest of its key, and when it expires. Never the key.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

struct GrantRecord {
    std::string role;
    std::string digest;                  ///< SHA-256 of the key, 64 hexadecimal digits
    std::optional<std::int64_t> expires; ///< seconds since 1970
};

/// JSON text.
std::string grant_text(const GrantRecord& record);

/// Error: Corrupt.
core::Result<GrantRecord> read_grant(std::string_view text);

} // namespace wakesurf::protocol
