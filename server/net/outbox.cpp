#include "server/net/outbox.hpp"

#include "server/limits.hpp"

namespace wakesurf::server {

bool Outbox::push(std::string message) {
    if (messages_.size() >= limits::outbox_messages ||
        message_bytes_ + message.size() > limits::outbox_message_bytes)
        return false;
    message_bytes_ += message.size();
    messages_.push_back(std::move(message));
    return true;
}

void Outbox::push(std::uint32_t surface, std::shared_ptr<const SurfaceState> state) {
    std::erase_if(states_, [&](const Pending& each) { return each.surface == surface; });
    states_.push_back({surface, std::move(state)});
}

void Outbox::drop_frames(std::uint32_t surface, std::uint32_t epoch) {
    std::erase_if(states_, [&](const Pending& each) {
        return each.surface == surface && each.state->epoch < epoch;
    });
}

std::optional<Outbox::Item> Outbox::pop() {
    if (!messages_.empty()) {
        Item item = std::move(messages_.front());
        messages_.pop_front();
        message_bytes_ -= std::get<std::string>(item).size();
        return item;
    }
    if (states_.empty())
        return std::nullopt;
    Pending& front = states_.front();
    Item item = front.state->frames[front.next++];
    if (front.next == front.state->frames.size())
        states_.pop_front();
    return item;
}

} // namespace wakesurf::server
