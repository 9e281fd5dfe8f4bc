#include "server/net/methods/notifications.hpp"

#include "protocol/api/json_rpc.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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

struct CacheEvents::Watched {
    std::string dataset;
    std::weak_ptr<core::TimeStepCache> cache;
    std::vector<core::StepHeld> announced;
    std::atomic<bool> pending{false}; ///< an announcement is on its way
    std::shared_ptr<void> timer;
};

CacheEvents::CacheEvents(Loop& loop, Announce announce)
    : loop_(loop), announce_(std::move(announce)) {}

CacheEvents::~CacheEvents() {
    for (const auto& [dataset, watched] : watched_)
        if (const auto cache = watched->cache.lock())
            cache->on_change({});
}

void CacheEvents::watch(const std::string& dataset,
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

void CacheEvents::changed(const std::shared_ptr<Watched>& watched) {
    watched->pending =
        false; // before looking: what changes from here on is announced the next time
    const auto cache = watched->cache.lock();
    if (!cache)
        return;
    const auto status = cache->status();
    const json message = cache_changes_json(watched->dataset, watched->announced, status);
    watched->announced = status.steps;
    if (!message["held"].empty())
        announce_(protocol::rpc_notification("cache.patched", message));
}

namespace {

constexpr const char* cure =
    "a surface is computed again when it is edited or its rake is moved, or by Compute it on the "
    "page; begin with small ones; the server's log and memory use may show why it died";

std::string reason(unsigned died) {
    return fmt::format(
        "the server died {} times in a row shortly after it had started, so existing "
        "surfaces are not rebuilt automatically",
        died);
}

/// Bounds how many records a sentence names; `keptAside` of session.join has more.
constexpr std::size_t most_named = 3;

} // namespace

std::string notice(std::string_view kind, std::string_view level, const std::string& text) {
    return protocol::rpc_notification("server.notice",
                                      {{"kind", kind}, {"level", level}, {"text", text}});
}

std::string durability_notice(const core::Result<void>& turn) {
    if (turn)
        return notice("durableAgain", "info",
                      "edits are saved again, including all made meanwhile");
    return notice("notDurable", "warning", "edits are not saved for now: " + turn.error().message);
}

core::Error withheld(unsigned died) {
    return {core::Error::Code::Cancelled, reason(died), cure};
}

std::string careful_notice(unsigned died) {
    return notice("carefulStart", "warning", reason(died) + ": " + cure);
}

std::string replaced_data_notice(const std::set<std::string>& names) {
    return notice("dataReplaced", "warning",
                  fmt::format("the data of {} have been replaced: its surfaces are computed again "
                              "from the new data",
                              fmt::join(names, ", ")));
}

std::string replaced_data_meanwhile_notice(const std::set<std::string>& names) {
    return notice("dataReplaced", "warning",
                  fmt::format("the data of {} have been replaced since this session was last used: "
                              "its surfaces are computed from the new data",
                              fmt::join(names, ", ")));
}

std::span<const KeptAside> newest_aside(const Session& session, std::size_t most) {
    const std::span all(session.kept_aside());
    return all.last(std::min(most, all.size()));
}

std::optional<std::string> kept_aside_notice(const Session& session) {
    const std::size_t count = session.newly_aside();
    if (count == 0)
        return std::nullopt;
    std::string whys;
    for (const KeptAside& each : newest_aside(session, std::min(count, most_named)))
        whys += (whys.empty() ? "" : "; ") + each.why;
    return notice(
        "recordsKeptAside", "warning",
        fmt::format(
            "{} of this session could not be used when the server started and {} kept "
            "aside: {}{}. Nothing was deleted: `wakesurf state aside STATE_DIR` prints {} as "
            "JSON, to be corrected and set again",
            count == 1 ? "a record" : fmt::format("{} records", count), count == 1 ? "is" : "are",
            whys, count > most_named ? "; ..." : "", count == 1 ? "it" : "them"));
}

} // namespace wakesurf::server
