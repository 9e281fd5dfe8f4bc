// Secrets as the server stores them: only their SHA-256. The secrets themselves are random, 256 bits, so that
// a digest is of no use to a table of likely ones.
#pragma once

#include "server/base/sha256.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Random bytes for secrets, injected so that whole sessions can be replayed.
class Entropy {
  public:
    virtual ~Entropy() = default;

    /// Fills `out` with random bytes. Throws std::runtime_error if the system has none.
    virtual void fill(std::span<std::byte> out) = 0;
};

/// Reads the kernel's generator.
class SystemEntropy final : public Entropy {
  public:
    void fill(std::span<std::byte> out) override;
};

/// Returns a secret of 8 * `bytes` bits, as hexadecimal digits.
std::string random_hex(Entropy& entropy, std::size_t bytes);

using SecretDigest = Digest;

/// Returns the digest. Throws std::runtime_error if the system has no SHA-256.
SecretDigest secret_digest(std::string_view secret);

/// Compares in constant time.
bool same_digest(const SecretDigest& a, const SecretDigest& b);

/// Parses a digest; empty if it is none.
std::optional<SecretDigest> read_digest(std::string_view text);

} // namespace wakesurf::server
