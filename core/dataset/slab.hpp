// Anonymous memory in huge pages for one time-step: 35-75 % faster advection than 4 KiB pages on
// 300 MB steps (docs/measurements.md, Pages), and read() into it never faults the way a mapped file can.
#pragma once

#include <cstddef>
#include <span>

namespace wakesurf::core {

/// Move-only owner of zeroed memory, aligned to 2 MiB where it is that large, followed by at least 64
/// readable bytes (wide loads of the last node). Throws std::bad_alloc.
class Slab {
  public:
    Slab() = default;
    /// Allocates zeroed memory. Throws std::bad_alloc.
    explicit Slab(std::size_t bytes);
    ~Slab();
    Slab(Slab&& other) noexcept;
    Slab& operator=(Slab&& other) noexcept;
    Slab(const Slab&) = delete;
    Slab& operator=(const Slab&) = delete;

    /// Returns as many bytes as were asked for.
    std::span<std::byte> bytes() { return {data_, size_}; }

    /// Returns as many bytes as were asked for.
    std::span<const std::byte> bytes() const { return {data_, size_}; }

    /// Returns the bytes that the operating system gave, page rounding included: the figure the cache
    /// accounts.
    std::size_t reserved() const { return reserved_; }

    /// Returns what a slab of `bytes` will reserve, in bytes.
    static std::size_t reservation(std::size_t bytes);

  private:
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t reserved_ = 0;
};

} // namespace wakesurf::core
