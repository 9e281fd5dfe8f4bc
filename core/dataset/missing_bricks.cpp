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

MissingBricks::Outcome MissingBricks::fetch(const std::stop_token& stop, bool anyway) {
    std::vector<std::uint32_t> bricks = std::exchange(bricks_, {});
    if (bricks.empty())
        return Outcome::None;
    std::sort(bricks.begin(), bricks.end());
    bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
    const std::size_t most = cache_->most_at_once() / steps_.size();
    if (bricks.size() > most && !anyway)
        return Outcome::TooMany;
    bricks.resize(std::min(bricks.size(), most));
    std::vector<BrickName> wanted;
    for (const std::size_t step : steps_)
        for (const std::uint32_t brick : bricks)
            wanted.push_back({step, brick, field_});
    if (auto fetched = cache_->fetch(wanted, stop); !fetched) {
        error_ = fetched.error();
        return Outcome::Failed;
    }
    return Outcome::Fetched;
}

} // namespace wakesurf::core
