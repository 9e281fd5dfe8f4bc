#include "protocol/wire/range_coder.hpp"

#include <utility>

namespace wakesurf::protocol {

namespace {

constexpr std::uint32_t least_range = 1u << 24;

} // namespace

bool RangeEncoder::bit(AdaptiveBit& likely, bool value) {
    narrow((range_ >> 16) * likely.one(), value);
    likely.saw(value);
    return value;
}

bool RangeEncoder::even(bool value) {
    narrow(range_ >> 1, value);
    return value;
}

Bytes RangeEncoder::finish() {
    for (int i = 0; i < 5; ++i)
        shift();
    return std::move(bytes_);
}

void RangeEncoder::narrow(std::uint32_t bound, bool value) {
    if (value) {
        range_ = bound;
    } else {
        low_ += bound;
        range_ -= bound;
    }
    for (; range_ < least_range; range_ <<= 8)
        shift();
}

void RangeEncoder::shift() {
    const auto carry = static_cast<std::uint8_t>(low_ >> 32);
    if (carry != 0 || low_ < 0xff000000u) {
        if (!before_first_)
            bytes_.push_back(static_cast<std::byte>(held_ + carry));
        bytes_.insert(bytes_.end(), pending_, static_cast<std::byte>(0xffu + carry));
        before_first_ = false;
        pending_ = 0;
        held_ = static_cast<std::uint8_t>(low_ >> 24);
    } else {
        ++pending_;
    }
    low_ = (low_ & 0x00ffffffu) << 8;
}

RangeDecoder::RangeDecoder(std::span<const std::byte> bytes) : bytes_(bytes) {
    for (int i = 0; i < 4; ++i)
        code_ = (code_ << 8) | next();
    impossible_ = code_ == range_; // it is always below
}

bool RangeDecoder::bit(AdaptiveBit& likely, bool) {
    const bool value = narrow((range_ >> 16) * likely.one());
    likely.saw(value);
    return value;
}

bool RangeDecoder::even(bool) {
    return narrow(range_ >> 1);
}

bool RangeDecoder::narrow(std::uint32_t bound) {
    const bool value = code_ < bound;
    if (value) {
        range_ = bound;
    } else {
        code_ -= bound;
        range_ -= bound;
    }
    for (; range_ < least_range; range_ <<= 8)
        code_ = (code_ << 8) | next();
    return value;
}

std::uint32_t RangeDecoder::next() {
    const std::size_t at = read_++;
    return at < bytes_.size() ? std::to_integer<std::uint32_t>(bytes_[at]) : 0u;
}

} // namespace wakesurf::protocol
