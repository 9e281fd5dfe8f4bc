// Secrets as the server keeps them: only their SHA-256. The secrets themselves are random, 256 bits, so that
// no table of likely ones helps anyone who gets to see a digest.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

using SecretDigest = std::array<std::byte, 32>;

/// Throws std::runtime_error where the system has no SHA-256.
SecretDigest secret_digest(std::string_view secret);

/// Takes the same time whatever differs.
bool same_digest(const SecretDigest& a, const SecretDigest& b);

/// 64 hexadecimal digits.
std::string digest_text(const SecretDigest& digest);

/// Returns nothing for what is not one.
std::optional<SecretDigest> read_digest(std::string_view text);

} // namespace wakesurf::server
