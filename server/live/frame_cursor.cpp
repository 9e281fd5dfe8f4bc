#include "server/live/frame_cursor.hpp"

#include "server/base/limits.hpp"

#include <utility>

namespace wakesurf::server {

FrameCursor::FrameCursor(std::shared_ptr<UpdateRing> ring,
                         std::optional<UpdatePosition> from,
                         Notice notice,
                         LeftOut left_out)
    : ring_(std::move(ring)), notice_(std::move(notice)), left_out_(std::move(left_out)) {
    const SharedUpdate newest = ring_->newest();
    if (!from || !newest || from->epoch != ring_->epoch())
        return;
    resumed_ = from->seq == newest->wire.seq || ring_->after(from->seq) != nullptr;
    if (resumed_) {
        state_ = from;
        met_ = true;
        passed_ = ring_->frames_before(from->seq + 1);
    }
}

FrameCursor::Frame FrameCursor::next() {
    if (sending_ && (sending_->wire.epoch != ring_->epoch() || ring_->newest() == nullptr))
        stop(); // frames of another epoch, or of a deleted surface, are obsolete
    if (!sending_)
        start(choose());
    if (!sending_)
        return nullptr;
    Frame frame = sending_->wire.frames[frame_++];
    if (frame_ < sending_->wire.frames.size())
        return frame;
    state_ = UpdatePosition{sending_->wire.epoch, sending_->wire.seq};
    met_ = true;
    unacknowledged_.push_back(*state_);
    if (!acknowledges_ && unacknowledged_.size() > limits::window)
        unacknowledged_.pop_front();
    sending_.reset();
    if (std::exchange(behind_, false))
        notice_(false);
    return frame;
}

void FrameCursor::start(SharedUpdate update) {
    sending_ = std::move(update);
    frame_ = 0;
    if (!sending_)
        return;
    const std::uint32_t seq = sending_->wire.seq;
    const std::uint64_t through = ring_->frames_before(seq + 1);
    // A key made on request also replaces the update to its state.
    const std::uint64_t before = ring_->holds(sending_) ? ring_->frames_before(seq) : through;
    if (passed_ && before > *passed_)
        leave_out(before - *passed_);
    passed_ = through;
}

void FrameCursor::stop() {
    leave_out(sending_->wire.frames.size() - frame_);
    sending_.reset();
}

void FrameCursor::leave_out(std::uint64_t frames) const {
    if (left_out_)
        left_out_(frames);
}

/// Returns the update to send after a whole one.
SharedUpdate FrameCursor::choose() {
    const SharedUpdate newest = ring_->newest();
    if (!newest)
        return nullptr;
    const bool here = state_ && state_->epoch == ring_->epoch();
    if (here && state_->seq == newest->wire.seq)
        return nullptr;
    if (!window_open(here && behind_)) {
        fall_behind();
        return nullptr;
    }
    if (here && !behind_) {
        SharedUpdate following = ring_->after(state_->seq);
        if (following && (following->wire.key || !ring_->far_behind(state_->seq)))
            return following;
        fall_behind();
    }
    // A new epoch begins with its earliest update: a line too slow for the final state shows the coarse one.
    if (!here && met_)
        if (SharedUpdate first = ring_->first())
            return first;
    return ring_->key(here ? std::optional(state_->seq) : std::nullopt);
}

void FrameCursor::fall_behind() {
    if (!std::exchange(behind_, true))
        notice_(true);
}

/// @param half  a keyframe is due, which is only worth its size once half of the window is free
bool FrameCursor::window_open(bool half) const {
    return !acknowledges_ || unacknowledged_.size() < limits::window / (half ? 2 : 1);
}

void FrameCursor::acknowledge(UpdatePosition position) {
    acknowledges_ = true;
    while (!unacknowledged_.empty() && unacknowledged_.front() <= position)
        unacknowledged_.pop_front();
}

} // namespace wakesurf::server
