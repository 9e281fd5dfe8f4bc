#include "server/net/outbox_memory.hpp"

#include "server/base/limits.hpp"

#include <algorithm>

namespace wakesurf::server {

namespace {

/// The change in bytes after which the account is updated: messages are frequent.
constexpr std::size_t step = std::size_t{256} << 10;

} // namespace

OutboxMemory::OutboxMemory(const core::MemoryAccount& account)
    : most_(account.budget() / limits::outboxes_part),
      counted_(account.open(core::MemoryUse::Messages)) {}

std::shared_ptr<void> OutboxMemory::hold(std::size_t bytes) {
    auto share = std::make_shared<Share>(this);
    return share->grow(bytes) ? share : nullptr;
}

bool OutboxMemory::fits(std::size_t own, std::size_t more) const {
    const std::size_t wanted = own + more;
    return wanted <= limits::outbox_small_bytes || wanted <= (most_ - std::min(most_, bytes_)) / 4;
}

void OutboxMemory::changed() {
    const std::size_t counted = bytes_ / step * step;
    if (counted != counted_.bytes())
        counted_.set(counted);
}

bool OutboxMemory::Share::grow(std::size_t more) {
    if (all_ == nullptr)
        return true;
    if (!all_->fits(bytes_, more))
        return false;
    bytes_ += more;
    all_->bytes_ += more;
    all_->changed();
    return true;
}

void OutboxMemory::Share::shrink(std::size_t less) {
    if (all_ == nullptr)
        return;
    less = std::min(less, bytes_);
    bytes_ -= less;
    all_->bytes_ -= less;
    all_->changed();
}

} // namespace wakesurf::server
