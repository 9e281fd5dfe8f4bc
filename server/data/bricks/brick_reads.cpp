#include "server/data/bricks/brick_reads.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

ReadsFromFiles::~ReadsFromFiles() {
    std::unique_lock lock(mutex_);
    none_left_.wait(lock, [&] { return left_ == 0; });
}

void ReadsFromFiles::begin(std::vector<WaitingRead> which) {
    {
        const std::scoped_lock lock(mutex_);
        left_ += which.size();
        count_ += which.size();
    }
    while (!which.empty()) {
        const auto asked = which.front().asked;
        const auto rest_of = std::stable_partition(
            which.begin(), which.end(), [&](const auto& each) { return each.asked == asked; });
        std::vector<core::BrickRead> reads;
        std::vector<std::size_t> indices;
        for (auto each = which.begin(); each != rest_of; ++each) {
            reads.push_back(each->read());
            indices.push_back(each->index);
        }
        which.erase(which.begin(), rest_of);
        files_.read(
            std::move(reads), asked->stop,
            [this, asked, indices = std::move(indices)](std::size_t i, core::Result<void> outcome) {
                asked->done(indices[i], std::move(outcome));
                const std::scoped_lock lock(mutex_);
                if (--left_ == 0)
                    none_left_.notify_all();
            });
    }
}

std::uint64_t ReadsFromFiles::count() const {
    const std::scoped_lock lock(mutex_);
    return count_;
}

void ReadsOnTheirWay::add(std::span<const std::uint32_t> slots, std::vector<WaitingRead> reads) {
    const Time now = options_.wall().now();
    for (std::size_t i = 0; i < slots.size(); ++i)
        by_slot_.insert_or_assign(slots[i], OnItsWay{std::move(reads[i]), now});
}

std::optional<WaitingRead> ReadsOnTheirWay::take(std::uint32_t slot) {
    auto found = by_slot_.extract(slot);
    return found ? std::move(found.mapped().read) : std::nullopt;
}

std::vector<WaitingRead> ReadsOnTheirWay::late() {
    const Time now = options_.wall().now();
    std::vector<WaitingRead> out;
    for (auto& [slot, each] : by_slot_)
        if (each.read && now - each.since >= options_.patience)
            out.push_back(*std::exchange(each.read, std::nullopt));
    return out;
}

bool ReadsOnTheirWay::nobody_waits() const {
    return std::ranges::none_of(by_slot_,
                                [](const auto& each) { return each.second.read.has_value(); });
}

bool ReadsOnTheirWay::hung() const {
    const Time now = options_.wall().now();
    return std::ranges::any_of(
        by_slot_, [&](const auto& each) { return now - each.second.since >= options_.hung; });
}

ReadsOnTheirWay::Time ReadsOnTheirWay::due() const {
    Time out = Time::max();
    for (const auto& [slot, each] : by_slot_)
        out =
            std::min(out, each.read ? each.since + options_.patience : each.since + options_.hung);
    return out;
}

std::vector<WaitingRead> ReadsOnTheirWay::end() {
    std::vector<WaitingRead> out;
    for (auto& [slot, each] : by_slot_)
        if (each.read)
            out.push_back(std::move(*each.read));
    by_slot_.clear();
    return out;
}

} // namespace wakesurf::server
