// Random bytes for secrets, injected so that whole sessions can be replayed.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace wakesurf::server {

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

} // namespace wakesurf::server
