#include "core/base/work_memory.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

// The account is asked for a part of what is taken already at a time.
constexpr std::size_t least_part = std::size_t{64} << 10;
constexpr std::size_t largest_part = std::size_t{4} << 20;

// Small work waits so much longer: large work that is asked to end runs at low priority, and was seen to take
// over a second.
constexpr int small_patience = 5;

} // namespace

bool WorkMemory::grow(std::size_t bytes) {
    const std::size_t now = taken_ += std::min(bytes, most);
    return (now <= reserved_ && !gives_way_) || reserve(now);
}

bool WorkMemory::grow_within_free(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    const std::size_t now = taken_ + std::min(bytes, most);
    if (exhausted_ || gives_way_)
        return false;
    if (now > reserved_) {
        if (!share_.grow_within_free(now + ahead_of(now), left_beside(now)))
            return false;
        if (now > account_.small() && !ticket_)
            give_way_from_now_on();
        reserved_ = share_.bytes();
    }
    taken_ += std::min(bytes, most);
    return true;
}

bool WorkMemory::grow_to(std::size_t bytes) {
    const std::size_t now = taken_;
    return bytes <= now || grow(bytes - now);
}

bool WorkMemory::reserve(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    if (exhausted_)
        return false;
    if (bytes <= reserved_ && !gives_way_)
        return true;
    if (bytes > account_.small() && !ticket_)
        give_way_from_now_on();
    const std::size_t leave = left_beside(bytes);
    if (gives_way_ ||
        (!share_.grow_within_free(bytes + ahead_of(bytes), leave) &&
         !share_.grow_to(bytes, end_.get_token(),
                         leave == 0 ? small_patience * patience_ : patience_, leave))) {
        wanted_ = bytes;
        exhausted_ = !stop_.stop_requested();
        return false;
    }
    reserved_ = share_.bytes();
    return true;
}

std::size_t WorkMemory::ahead_of(std::size_t bytes) const {
    return std::clamp(bytes / 16, least_part, largest_part);
}

std::size_t WorkMemory::left_beside(std::size_t bytes) const {
    return bytes > account_.small() ? account_.reserved_for_small() : 0;
}

void WorkMemory::give_way_from_now_on() {
    ticket_ = account_.on_need(ReclaimOrder::Builds, [this](std::size_t) {
        gives_way_ = true;
        end_.request_stop();
    });
}

Error WorkMemory::refusal() const {
    if (!exhausted_)
        return {Error::Code::Cancelled, "the work was cancelled", ""};
    return gives_way_ ? account_.gave_way(what_, reserved_) : account_.refusal(what_, wanted_);
}

} // namespace wakesurf::core
