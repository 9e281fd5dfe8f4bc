// Secrets as the server stores them: only their SHA-256. The secrets themselves are random, 256 bits, so that
// a digest is of no use to a table of likely ones.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

using SecretDigest = std::array<std::byte, 32>;

/// Returns the digest. Throws std::runtime_error if the system has no SHA-256.
SecretDigest secret_digest(std::string_view secret);

/// Compares in constant time.
bool same_digest(const SecretDigest& a, const SecretDigest& b);

/// Returns 64 hexadecimal digits.
std::string digest_text(const SecretDigest& digest);

/// Parses a digest; empty if it is none.
std::optional<SecretDigest> read_digest(std::string_view text);

} // namespace wakesurf::server
