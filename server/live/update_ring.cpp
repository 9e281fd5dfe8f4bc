#include "server/live/update_ring.hpp"

#include "core/base/work_memory.hpp"
#include "server/base/limits.hpp"
#include "server/base/metrics.hpp"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>
#include <stop_token>
#include <utility>

namespace wakesurf::server {

namespace {

/// The wait for others to release memory.
constexpr std::chrono::milliseconds patience_for_key{100};

} // namespace

SharedUpdate keyframe_of(const Update& update,
                         std::shared_ptr<const protocol::WireMesh> state,
                         std::uint32_t number,
                         const core::MemoryAccount* account) {
    std::optional<core::WorkMemory> memory;
    if (account != nullptr)
        memory.emplace(*account, std::stop_token(), patience_for_key);
    try {
        if (memory && !memory->grow(state->vertices() * protocol::encoding_bytes))
            return nullptr;
        protocol::EncodedUpdate from = update.wire;
        from.state = std::move(state);
        auto encoded = protocol::encode_key(number, from);
        if (!encoded)
            return nullptr;
        auto key = std::make_shared<Update>(update);
        key->wire = std::move(*encoded);
        key->wire.state.reset();
        key->memory = counted(account, key->wire.bytes);
        return key;
    } catch (const std::bad_alloc&) { // as without memory
        return nullptr;
    }
}

void count(Metrics& metrics,
           std::chrono::duration<double> queued,
           const core::Result<Update>& result,
           bool whole) {
    metrics.observe(Stage::Queue, queued.count());
    if (result)
        metrics.observe(Stage::Encode, result->took.encode);
    if (result && whole) {
        metrics.observe(Stage::Load, result->statistics.seconds.load);
        metrics.observe(Stage::Advect, result->statistics.seconds.advect);
        metrics.observe(Stage::Refine, result->statistics.seconds.refine);
    }
}

std::shared_ptr<core::MemoryAccount::Share> counted(const core::MemoryAccount* account,
                                                    std::size_t bytes) {
    if (account == nullptr)
        return nullptr;
    auto share = account->open(core::MemoryUse::Rings);
    share.set(bytes);
    return std::make_shared<core::MemoryAccount::Share>(std::move(share));
}

UpdateRing::UpdateRing(std::uint32_t number,
                       const core::Clock& clock,
                       std::function<void()> want_key)
    : number_(number), clock_(clock), want_key_(std::move(want_key)) {}

void UpdateRing::begin(std::uint32_t epoch) {
    epoch_ = epoch;
    updates_.clear();
    since_.clear();
    bytes_ = 0;
    key_bytes_ = 0;
    key_.reset();
    state_.reset();
    key_wanted_ = false;
    notify();
}

void UpdateRing::add(SharedUpdate update, std::shared_ptr<const protocol::WireMesh> state) {
    if (closed_ || update->wire.epoch != epoch_)
        return;
    bytes_ += update->wire.bytes;
    frames_ += update->wire.frames.size();
    if (update->wire.key)
        key_bytes_ = update->wire.bytes;
    state_ = update->wire.key ? nullptr : std::move(state);
    updates_.push_back(std::move(update));
    since_.push_back(clock_.now());
    trim();
    notify();
}

void UpdateRing::add_key(SharedUpdate key) {
    key_wanted_ = false;
    if (closed_ || (key && key->wire.epoch != epoch_))
        return;
    key_ = std::move(key);
    key_since_ = clock_.now();
    if (key_)
        key_bytes_ = key_->wire.bytes;
    notify();
}

void UpdateRing::trim() {
    const auto oldest = clock_.now() - limits::ring_age;
    while (updates_.size() > 1 && (bytes_ > limits::ring_bytes || since_.front() < oldest)) {
        bytes_ -= updates_.front()->wire.bytes;
        updates_.pop_front();
        since_.pop_front();
    }
    // A key is of use while the updates after it are held.
    if (key_ && !updates_.empty() && key_->wire.seq + 1 < updates_.front()->wire.seq)
        key_.reset();
}

void UpdateRing::keep_newest() {
    while (updates_.size() > 1) {
        bytes_ -= updates_.front()->wire.bytes;
        updates_.pop_front();
        since_.pop_front();
    }
    trim();
}

bool UpdateRing::read() const {
    return std::ranges::any_of(listeners_, [](const auto& each) { return !each.expired(); });
}

void UpdateRing::close() {
    closed_ = true;
    begin(epoch_);
}

SharedUpdate UpdateRing::first() const {
    return updates_.empty() || !updates_.front()->wire.key ? nullptr : updates_.front();
}

SharedUpdate UpdateRing::after(std::uint32_t seq) const {
    for (auto it = updates_.rbegin(); it != updates_.rend() && (*it)->wire.seq > seq; ++it)
        if ((*it)->wire.key || (*it)->wire.base_seq == seq)
            return *it;
    return nullptr;
}

bool UpdateRing::far_behind(std::uint32_t seq) const {
    std::size_t bytes = 0;
    for (auto it = updates_.rbegin(); it != updates_.rend() && (*it)->wire.seq > seq; ++it)
        bytes += (*it)->wire.bytes;
    return bytes > std::max(limits::behind_bytes, key_bytes_);
}

bool UpdateRing::holds(const SharedUpdate& update) const {
    return std::find(updates_.begin(), updates_.end(), update) != updates_.end();
}

std::uint64_t UpdateRing::frames_before(std::uint32_t seq) const {
    std::uint64_t frames = frames_;
    for (auto it = updates_.rbegin(); it != updates_.rend() && (*it)->wire.seq >= seq; ++it)
        frames -= (*it)->wire.frames.size();
    return frames;
}

SharedUpdate UpdateRing::key(std::optional<std::uint32_t> after_seq) {
    if (updates_.empty())
        return nullptr;
    const std::uint32_t newest = updates_.back()->wire.seq;
    const auto of_use = [&](const SharedUpdate& key) {
        return !after_seq || key->wire.seq > *after_seq;
    };
    const auto near = [&](std::uint32_t seq) {
        return newest - seq <= limits::window / 2 && !far_behind(seq);
    };
    for (auto it = updates_.rbegin(); it != updates_.rend() && of_use(*it); ++it)
        if ((*it)->wire.key && near((*it)->wire.seq))
            return *it;
    if (key_ && of_use(key_)) {
        const std::uint32_t seq = key_->wire.seq;
        const bool leads_on = seq == newest || after(seq) != nullptr;
        // A key that has just been made is good enough, or it would be obsolete for ever while a large
        // surface plays.
        if (leads_on && (near(seq) || clock_.now() - key_since_ < limits::key_age))
            return key_;
    }
    if (!std::exchange(key_wanted_, true))
        want_key_();
    return nullptr;
}

std::shared_ptr<void> UpdateRing::listen(std::function<void()> notify) {
    auto listener = std::make_shared<Listener>(std::move(notify));
    std::erase_if(listeners_, [](const auto& each) { return each.expired(); });
    listeners_.push_back(listener);
    return listener;
}

void UpdateRing::notify() {
    for (const auto& each : std::vector(listeners_))
        if (const auto listener = each.lock())
            (*listener)();
}

} // namespace wakesurf::server
