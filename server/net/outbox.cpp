#include "server/net/outbox.hpp"

#include "server/base/limits.hpp"

#include <algorithm>
#include <utility>

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

bool Outbox::push(Message message) {
    if (messages_.size() >= limits::outbox_messages ||
        message_bytes_ + message->size() > limits::outbox_message_bytes)
        return false;
    // The caller holds one reference; earlier clients have counted theirs already.
    const long others = std::max(1L, message.use_count() - 1);
    const std::size_t share = message->size() / static_cast<std::size_t>(others);
    if (!memory_.grow(share))
        return false;
    message_bytes_ += message->size();
    messages_.push_back({std::move(message), share});
    return true;
}

bool Outbox::may_follow(std::uint32_t surface) {
    std::erase_if(cursors_, [](const auto& each) { return each.second.ring().closed(); });
    return cursors_.contains(surface) || cursors_.size() < limits::subscriptions;
}

void Outbox::follow(FrameCursor cursor) {
    const std::uint32_t surface = cursor.ring().number();
    cursors_.insert_or_assign(surface, std::move(cursor));
}

bool Outbox::unfollow(std::uint32_t surface) {
    return cursors_.erase(surface) > 0;
}

FrameCursor* Outbox::cursor(std::uint32_t surface) {
    const auto found = cursors_.find(surface);
    return found == cursors_.end() ? nullptr : &found->second;
}

std::optional<Outbox::Item> Outbox::pop(bool frames) {
    if (auto message = pop_message(); message || !frames)
        return message;
    if (Frame frame = pop_frame())
        return frame;
    return pop_message(); // messages of the cursors come first
}

std::optional<Outbox::Item> Outbox::pop_message() {
    if (messages_.empty())
        return std::nullopt;
    Message message = std::move(messages_.front().message);
    popped_ += messages_.front().share;
    messages_.pop_front();
    message_bytes_ -= message->size();
    return message;
}

void Outbox::sent() {
    memory_.shrink(std::exchange(popped_, 0));
}

Outbox::Frame Outbox::pop_frame() {
    auto next = cursors_.upper_bound(last_);
    for (std::size_t turns = cursors_.size(); turns > 0; --turns, ++next) {
        if (next == cursors_.end())
            next = cursors_.begin();
        if (Frame frame = next->second.next()) {
            last_ = next->first;
            return frame;
        }
    }
    return nullptr;
}

} // namespace wakesurf::server
