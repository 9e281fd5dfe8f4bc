#include "server/net/methods/cache_news.hpp"

#include "protocol/api/json_rpc.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <utility>
#include <vector>

namespace wakesurf::server {

using nlohmann::json;

namespace {

// Time-steps that are read at the disk's speed change state far more often than a person can look.
constexpr std::chrono::milliseconds rest{100};

/// Returns the parameters of cache.patched: what differs from `before`, which may be empty or shorter.
json cache_changes_json(const std::string& dataset,
                        const std::vector<core::StepHeld>& before,
                        const core::TimeStepCache::Status& status) {
    json changes = json::array();
    json held = json::array();
    for (std::size_t i = 0; i < status.steps.size(); ++i) {
        const core::StepHeld& now = status.steps[i];
        if (i >= before.size() || before[i].state() != now.state())
            changes.push_back(json::array({i, name_of(now.state())}));
        if (i >= before.size() || before[i] != now)
            held.push_back(json::array({i, now.resident, now.loading}));
    }
    return {{"dataset", dataset},
            {"changes", std::move(changes)},
            {"held", std::move(held)},
            {"bytes", status.bytes},
            {"budget", status.budget}};
}

} // namespace

const char* name_of(core::StepState state) {
    switch (state) {
    case core::StepState::Resident:
        return "resident";
    case core::StepState::Loading:
        return "loading";
    case core::StepState::Cold:
        break;
    }
    return "cold";
}

struct CacheNews::Watched {
    std::string dataset;
    std::weak_ptr<core::TimeStepCache> cache;
    std::vector<core::StepHeld> told;
    std::atomic<bool> pending{false}; ///< an announcement is on its way
    std::shared_ptr<void> timer;
};

CacheNews::CacheNews(Loop& loop, Announce announce) : loop_(loop), announce_(std::move(announce)) {}

CacheNews::~CacheNews() {
    for (const auto& [dataset, watched] : watched_)
        if (const auto cache = watched->cache.lock())
            cache->on_change({});
}

void CacheNews::watch(const std::string& dataset,
                      const std::shared_ptr<core::TimeStepCache>& cache) {
    auto& place = watched_[dataset];
    if (cache == nullptr || (place && place->cache.lock() == cache))
        return;
    if (place)
        if (const auto before = place->cache.lock())
            before->on_change({});
    place = std::make_shared<Watched>();
    place->dataset = dataset;
    place->cache = cache;
    cache->on_change([this, weak = std::weak_ptr(place)] {
        const auto watched = weak.lock();
        if (watched && !watched->pending.exchange(true))
            loop_.post([this, weak] {
                if (const auto still = weak.lock())
                    still->timer = loop_.after(rest, [this, weak] {
                        if (const auto due = weak.lock())
                            changed(due);
                    });
            });
    });
}

void CacheNews::changed(const std::shared_ptr<Watched>& watched) {
    watched->pending = false; // before looking: what changes from here on is told the next time
    const auto cache = watched->cache.lock();
    if (!cache)
        return;
    const auto status = cache->status();
    const json message = cache_changes_json(watched->dataset, watched->told, status);
    watched->told = status.steps;
    if (!message["held"].empty())
        announce_(protocol::rpc_notification("cache.patched", message));
}

} // namespace wakesurf::server
