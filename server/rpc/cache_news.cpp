#include "server/rpc/cache_news.hpp"

#include "protocol/api/json_rpc.hpp"
#include "server/rpc/cache_json.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <utility>
#include <vector>

namespace wakesurf::server {

namespace {

// Time-steps that are read at the disk's speed change state far more often than anybody can look.
constexpr std::chrono::milliseconds rest{100};

} // namespace

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
    const auto message = cache_changes_json(watched->dataset, watched->told, status);
    watched->told = status.steps;
    if (!message["held"].empty())
        announce_(protocol::rpc_notification("cache.patched", message));
}

} // namespace wakesurf::server
