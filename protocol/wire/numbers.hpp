// The numbers that an update begins with: varints, deflated. protocol/wire/FORMAT.md, Update. Twin:
// web-client/src/protocol/bytes.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Packs numbers for the beginning of an update. Cost: some 10 ns a number.
core::Result<Bytes> pack_numbers(std::span<const std::uint32_t> numbers);

/// Holds numbers to be taken in order. Once one is missing or too large, it has failed, and all that follow
/// are 0.
class Numbers {
  public:
    explicit Numbers(std::vector<std::uint32_t> all) : all_(std::move(all)) {}

    bool failed() const { return failed_; }

    std::size_t left() const { return all_.size() - at_; }

    std::uint32_t next(std::uint32_t most = 0xffffffffu) {
        failed_ = failed_ || at_ == all_.size() || all_[at_] > most;
        return failed_ ? 0u : all_[at_++];
    }

    std::int32_t next_signed() { return static_cast<std::int32_t>(unzigzag(next())); }

    /// Takes the next `count`; empty if there are fewer.
    std::span<const std::uint32_t> take(std::size_t count) {
        failed_ = failed_ || count > left();
        if (failed_)
            return {};
        at_ += count;
        return std::span(all_).subspan(at_ - count, count);
    }

  private:
    std::vector<std::uint32_t> all_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

/// Unpacks the numbers at the beginning of an update's bytes: `update` is then what follows them. Error:
/// Corrupt. Allocates O(bytes) at most, by the bound on deflate.
core::Result<Numbers> unpack_numbers(std::span<const std::byte>& update);

} // namespace wakesurf::protocol
