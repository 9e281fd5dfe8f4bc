// Binary arithmetic coding with probabilities that both ends learn alike from what has been coded: what the cells code is
// written with. protocol/wire/README.md, Range code. Carry propagation as in LZMA's range coder (Pavlov; after Martin 1979). Twin:
// web-client/src/protocol/rangeDecoder.ts.
#pragma once

#include "protocol/wire/bytes.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::protocol {

/// How likely a decision is, from how it went before: the more it has seen, the less a new one weighs.
class AdaptiveBit {
  public:
    /// Of 2^16: 32 to 65504.
    std::uint32_t one() const { return one_; }

    void saw(bool bit) {
        constexpr std::uint32_t least = 32;
        constexpr std::uint32_t certain = 1u << 16;
        constexpr std::uint8_t longest_memory = 30;
        const std::uint32_t rate = 131072u / (2u * seen_ + 3u);
        if (bit)
            one_ += ((certain - one_) * rate) >> 16;
        else
            one_ -= (one_ * rate) >> 16;
        one_ = one_ < least ? least : one_ > certain - least ? certain - least : one_;
        if (seen_ < longest_memory)
            ++seen_;
    }

  private:
    std::uint32_t one_ = 1u << 15;
    std::uint8_t seen_ = 0;
};

/// Coders of both directions have the same calls, so that one function both writes and reads.
class RangeEncoder {
  public:
    static constexpr bool writes = true;

    bool bit(AdaptiveBit& likely, bool value);

    /// A decision about which nothing is known.
    bool even(bool value);

    Bytes finish();

  private:
    void narrow(std::uint32_t bound, bool value);
    void shift();

    std::uint64_t low_ = 0;
    std::uint32_t range_ = 0xffffffffu;
    std::uint8_t held_ = 0;    ///< a byte that a carry may still reach,
    std::size_t pending_ = 0;  ///< and bytes 0xff after it
    bool before_first_ = true; ///< the first byte held is none
    Bytes bytes_;
};

/// Never reads outside its bytes; behind their end it sees zeros.
class RangeDecoder {
  public:
    static constexpr bool writes = false;

    explicit RangeDecoder(std::span<const std::byte> bytes);

    /// @param value  for the likeness to RangeEncoder; not looked at
    bool bit(AdaptiveBit& likely, bool value = false);
    bool even(bool value = false);

    /// Whether all has been read that finish() gave, and no more.
    bool exhausted() const { return !impossible_ && read_ == bytes_.size(); }

    /// Whether this cannot be what finish() gave.
    bool failed() const { return impossible_ || read_ > bytes_.size(); }

    /// Something was read that no encoder writes.
    void fail() { impossible_ = true; }

  private:
    bool narrow(std::uint32_t bound);
    std::uint32_t next();

    std::span<const std::byte> bytes_;
    std::size_t read_ = 0;
    std::uint32_t range_ = 0xffffffffu;
    std::uint32_t code_ = 0;
    bool impossible_ = false;
};

/// Numbers that are mostly small: how many bits, then the bits, of which the two below the highest are learnt.
class AdaptiveNumber {
  public:
    template <class Coder>
    std::uint32_t code(Coder& coder, std::uint32_t value) {
        const auto width = code_width(coder, static_cast<unsigned>(std::bit_width(value)));
        std::uint32_t result = width > 0 ? 1u : 0u;
        for (unsigned left = width > 0 ? width - 1 : 0; left > 0; --left) {
            const bool bit = ((value >> (left - 1)) & 1u) != 0;
            const unsigned place = width - 1 - left;
            const bool read = place == 0   ? coder.bit(high_[3 * width], bit)
                              : place == 1 ? coder.bit(high_[3 * width + 1 + (result & 1u)], bit)
                                           : coder.even(bit);
            result = (result << 1) | (read ? 1u : 0u);
        }
        return result;
    }

  private:
    /// 0 to 32 as a walk down a tree.
    template <class Coder>
    unsigned code_width(Coder& coder, unsigned width) {
        unsigned node = 1;
        for (unsigned level = 6; level > 0; --level)
            node = (node << 1) |
                   (coder.bit(width_[node], ((width >> (level - 1)) & 1u) != 0) ? 1u : 0u);
        if constexpr (!Coder::writes)
            if (node > 96u)
                coder.fail();
        return node > 96u ? 0u : node - 64u;
    }

    std::array<AdaptiveBit, 64> width_;
    std::array<AdaptiveBit, 99> high_;
};

} // namespace wakesurf::protocol
