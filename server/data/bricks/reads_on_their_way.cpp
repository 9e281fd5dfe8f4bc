#include "server/data/bricks/reads_on_their_way.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

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
