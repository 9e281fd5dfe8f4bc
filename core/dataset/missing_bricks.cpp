#include "core/dataset/missing_bricks.hpp"

#include <algorithm>

namespace wakesurf::core {

bool MissingBricks::give_up() {
    error_ =
        over_limit(
            cache_->status().budget,
            "one particle's way between two stored times needs more bricks than the cache holds",
            "start with more --memory")
            .value();
    return false;
}

namespace {

std::vector<std::uint32_t> each_once(std::vector<std::uint32_t> bricks) {
    std::sort(bricks.begin(), bricks.end());
    bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
    return bricks;
}

} // namespace

MissingBricks::Outcome MissingBricks::fetch(const std::stop_token& stop, bool anyway) {
    std::vector<std::uint32_t> bricks = each_once(std::exchange(bricks_, {}));
    const std::vector<std::uint32_t> ahead = each_once(std::exchange(ahead_, {}));
    std::vector<BrickName> wanted, soon;
    for (const std::size_t step : steps_)
        for (const std::uint32_t brick : ahead)
            soon.push_back({step, brick, field_});
    const std::size_t bytes = std::exchange(bytes_, 0);
    if (bytes > 0 && !memory_->make_room(bytes))
        return Outcome::Failed;
    if (bricks.empty() && !soon.empty())
        cache_->prefetch(soon);
    if (bricks.empty())
        return bytes > 0 ? Outcome::Fetched : Outcome::None;
    const std::size_t most = cache_->most_at_once() / steps_.size();
    if (bricks.size() > most && !anyway)
        return Outcome::TooMany;
    bricks.resize(std::min(bricks.size(), most));
    for (const std::size_t step : steps_)
        for (const std::uint32_t brick : bricks)
            wanted.push_back({step, brick, field_});
    if (auto fetched = cache_->fetch(wanted, stop, soon); !fetched) {
        error_ = fetched.error();
        return Outcome::Failed;
    }
    return Outcome::Fetched;
}

} // namespace wakesurf::core
