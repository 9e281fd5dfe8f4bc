// SHA-256 of bytes that come in parts.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace wakesurf::server {

using Digest = std::array<std::byte, 32>;

/// Sums up parts in order: how they are cut makes no difference. Throws std::runtime_error if the system has no SHA-256.
class Sha256 {
  public:
    Sha256();

    void add(std::span<const std::byte> bytes);

    void add(std::string_view text) { add(std::as_bytes(std::span(text))); }

    /// Returns the digest of all parts; ends the sum.
    Digest digest();

  private:
    struct Free {
        void operator()(void* context) const;
    };

    std::unique_ptr<void, Free> context_;
};

/// Returns 64 hexadecimal digits.
std::string digest_text(const Digest& digest);

} // namespace wakesurf::server
