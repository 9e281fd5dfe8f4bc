// Random bytes for secrets, injected so that whole sessions can be replayed.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace wakesurf::server {

class Entropy {
  public:
    virtual ~Entropy() = default;

    /// Throws std::runtime_error when the system has none to give.
    virtual void fill(std::span<std::byte> out) = 0;
};

/// The kernel's generator.
class SystemEntropy final : public Entropy {
  public:
    void fill(std::span<std::byte> out) override;
};

/// A secret of 8 * `bytes` bits, as hexadecimal digits.
std::string random_hex(Entropy& entropy, std::size_t bytes);

} // namespace wakesurf::server
