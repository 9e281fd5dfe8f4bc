#include "server/base/metrics.hpp"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace wakesurf::server {

std::string health_text(std::span<const DatasetCount> datasets) {
    std::size_t total = 0;
    std::string wrong;
    for (const DatasetCount& each : datasets) {
        total += each.count;
        if (each.count == 0)
            continue;
        const std::string is = each.count == 1 ? " is " : " are ";
        const std::string has = each.count == 1 ? " has " : " have ";
        const std::string said = each.state == "failed"       ? has + "failed"
                                 : each.state == "incomplete" ? is + "incomplete"
                                                              : std::string();
        if (!said.empty())
            wrong += (wrong.empty() ? "" : ", ") + std::to_string(each.count) + said;
    }
    return wrong.empty() ? "ok" : "ok, but of " + std::to_string(total) + " datasets " + wrong;
}

MemoryStatus memory_status(const core::MemoryAccount& account) {
    MemoryStatus out{account.budget(), account.used(), {}, account.refused()};
    for (std::size_t i = 0; i < out.by_use.size(); ++i)
        out.by_use[i] = account.used(static_cast<core::MemoryUse>(i));
    return out;
}

ProcessMemory process_memory() {
    ProcessMemory out;
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t kibibytes = 0;
        if (!(words >> name >> kibibytes))
            continue;
        if (name == "VmRSS:")
            out.resident = kibibytes << 10;
        else if (name == "VmHWM:")
            out.peak = kibibytes << 10;
    }
    std::error_code error;
    const std::filesystem::directory_iterator open("/proc/self/fd", error);
    if (!error)
        out.descriptors = static_cast<std::uint64_t>(std::distance(begin(open), end(open)));
    return out;
}

void RecentValues::add(Time now, double value) {
    const std::lock_guard lock(mutex_);
    values_[added_++ % most] = {now, static_cast<float>(value)};
}

Quantiles RecentValues::quantiles(Time now) const {
    std::vector<double> recent;
    {
        const std::lock_guard lock(mutex_);
        const auto held = std::min<std::uint64_t>(added_, most);
        for (std::size_t i = 0; i < held; ++i)
            if (now - values_[i].at <= window)
                recent.push_back(static_cast<double>(values_[i].value));
    }
    if (recent.empty())
        return {};
    std::sort(recent.begin(), recent.end());
    const auto at = [&](double part) {
        const auto rank = std::ceil(part * static_cast<double>(recent.size()));
        return recent[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
    };
    return {at(0.50), at(0.95), at(0.99), recent.size()};
}

using prometheus::Counter;
using prometheus::Family;
using prometheus::Gauge;
using prometheus::Histogram;
using prometheus::Registry;

namespace {

/// The bounds of buckets (s), finer about the promised figures: 5, 25, 50 and 160 ms.
const Histogram::BucketBoundaries latencies{0.0001, 0.0005, 0.001, 0.0025, 0.005, 0.01,
                                            0.025,  0.05,   0.1,   0.16,   0.25,  0.5,
                                            1.0,    2.5,    10.0,  60.0};

Family<Counter>& counters(Registry& registry, const char* name, const char* help) {
    return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}

Counter& counter(Registry& registry, const char* name, const char* help) {
    return counters(registry, name, help).Add({});
}

Family<Gauge>& gauges(Registry& registry, const char* name, const char* help) {
    return prometheus::BuildGauge().Name(name).Help(help).Register(registry);
}

Family<Histogram>& histograms(Registry& registry, const char* name, const char* help) {
    return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
}

std::uint64_t whole(const Counter& counted) {
    return static_cast<std::uint64_t>(counted.Value());
}

/// Holds one reading only: it is rebuilt each time, so that a removed dataset leaves nothing behind.
void collect(const ServerStatus& status, Registry& registry) {
    const auto gauge = [&](const char* name, const char* help, auto value) {
        gauges(registry, name, help).Add({}).Set(static_cast<double>(value));
    };
    gauge("wakesurf_uptime_seconds", "Time since the server started.", status.uptime);
    gauge("wakesurf_connections", "Open connections of all kinds.", status.connections);
    gauge("wakesurf_clients", "Open WebSockets.", status.clients);
    gauge("wakesurf_participants", "People and scripts in sessions.", status.participants);
    gauge("wakesurf_sessions", "Sessions.", status.sessions);
    gauge("wakesurf_surfaces", "Surfaces in all sessions.", status.surfaces);
    auto& datasets = gauges(registry, "wakesurf_datasets", "Datasets, by state.");
    for (const DatasetCount& each : status.datasets)
        datasets.Add({{"state", std::string(each.state)}}).Set(static_cast<double>(each.count));
    const ProcessMemory memory = process_memory();
    gauge("process_resident_memory_bytes", "Resident memory of the process.", memory.resident);
    gauge("process_open_fds", "Open file descriptors.", memory.descriptors);
    gauge("wakesurf_memory_budget_bytes", "The budget --memory, for the process and its importers.",
          status.memory.budget);
    gauge("wakesurf_memory_refused", "How often something did not fit into --memory.",
          status.memory.refused);
    auto& uses = gauges(registry, "wakesurf_memory_bytes", "Memory taken of --memory, by use.");
    for (std::size_t i = 0; i < status.memory.by_use.size(); ++i)
        uses.Add({{"use", std::string(core::name_of(static_cast<core::MemoryUse>(i)))}})
            .Set(static_cast<double>(status.memory.by_use[i]));
    auto& hits = counters(registry, "wakesurf_cache_hits_total",
                          "Requested time-steps that were already in memory.");
    auto& loads =
        counters(registry, "wakesurf_cache_loads_total", "Time-steps read from the disk.");
    auto& bytes = gauges(registry, "wakesurf_cache_bytes", "Memory that time-steps take.");
    auto& budget =
        gauges(registry, "wakesurf_cache_budget_bytes", "Memory that time-steps may take.");
    for (const CacheStatus& each : status.caches) {
        const prometheus::Labels labels{{"dataset", each.dataset}};
        hits.Add(labels).Increment(static_cast<double>(each.hits));
        loads.Add(labels).Increment(static_cast<double>(each.loads));
        bytes.Add(labels).Set(static_cast<double>(each.bytes));
        budget.Add(labels).Set(static_cast<double>(each.budget));
    }
    auto& bricks =
        counters(registry, "wakesurf_bricks_total", "Bricks read, by where they came from.");
    auto& ranks = gauges(registry, "wakesurf_brick_ranks",
                         "Ranks of the MPI job that holds bricks; 0 while there is none.");
    for (const BricksStatus& each : status.bricks) {
        bricks.Add({{"dataset", each.dataset}, {"from", "ranks"}})
            .Increment(static_cast<double>(each.by_ranks));
        bricks.Add({{"dataset", each.dataset}, {"from", "files"}})
            .Increment(static_cast<double>(each.by_files));
        ranks.Add({{"dataset", each.dataset}}).Set(static_cast<double>(each.ranks));
    }
}

} // namespace

struct Metrics::State {
    explicit State(const core::Clock& time) : clock(time) {
        auto& family = histograms(registry, "wakesurf_stage_seconds",
                                  "Time from an edit to the socket, by stage.");
        for (std::size_t i = 0; i < stages.size(); ++i)
            stages[i] = &family.Add({{"stage", std::string(stage_names[i])}}, latencies);
        auto& reasons = counters(registry, "wakesurf_rejected_total",
                                 "Requests and connections refused or ended, by reason.");
        for (std::size_t i = 0; i < rejected.size(); ++i)
            rejected[i] = &reasons.Add({{"reason", std::string(rejection_names[i])}});
        auto& kinds = counters(registry, "wakesurf_over_budget_total",
                               "Requests refused or delayed, by the budget they exceeded.");
        for (std::size_t i = 0; i < over_budget.size(); ++i)
            over_budget[i] = &kinds.Add({{"kind", std::string(budgeted_names[i])}});
        gauges(registry, "wakesurf_build_info", "Always 1; the label holds the version.")
            .Add({{"version", WAKESURF_VERSION}})
            .Set(1.0);
    }

    const core::Clock& clock;
    Registry registry;
    std::array<Histogram*, stage_names.size()> stages{};
    Histogram& edit_to_frame = histograms(registry,
                                          "wakesurf_edit_to_first_frame_seconds",
                                          "Time from an edit to the first frame that shows it.")
                                   .Add({}, latencies);
    Counter& frames = counter(registry, "wakesurf_frames_sent_total", "Mesh frames sent.");
    Counter& frame_bytes =
        counter(registry, "wakesurf_frame_bytes_sent_total", "Bytes of mesh frames sent.");
    Counter& messages = counter(registry, "wakesurf_messages_sent_total", "Text messages sent.");
    Counter& message_bytes =
        counter(registry, "wakesurf_message_bytes_sent_total", "Bytes of text messages sent.");
    Counter& received =
        counter(registry, "wakesurf_messages_received_total", "Messages received from clients.");
    Counter& received_bytes = counter(registry,
                                      "wakesurf_message_bytes_received_total",
                                      "Bytes of messages received from clients.");
    Counter& keyframes = counter(registry, "wakesurf_keyframes_total", "Keyframes sent.");
    Counter& behind = counter(registry,
                              "wakesurf_catching_up_total",
                              "How often a client fell behind and got a keyframe instead.");
    Counter& dropped = counter(registry,
                               "wakesurf_frames_dropped_total",
                               "Stale frames not sent because of a keyframe or a newer edit.");
    Family<Counter>& errors =
        counters(registry, "wakesurf_rpc_errors_total", "Calls answered with an error, by code.");
    Family<Gauge>& durable = gauges(
        registry, "wakesurf_state_durable", "1 while edits reach the disk, 0 while they do not.");
    std::array<Counter*, rejection_names.size()> rejected{};
    std::array<Counter*, budgeted_names.size()> over_budget{};
    std::array<RecentValues, stage_names.size()> recent;
    RecentValues recent_first_frames;
};

Metrics::Metrics(const core::Clock& clock) : state_(std::make_unique<State>(clock)) {}

Metrics::~Metrics() = default;

void Metrics::observe(Stage stage, double seconds) {
    const auto index = static_cast<std::size_t>(stage);
    state_->stages[index]->Observe(seconds);
    state_->recent[index].add(state_->clock.now(), seconds);
}

void Metrics::first_frame(double seconds) {
    state_->edit_to_frame.Observe(seconds);
    state_->recent_first_frames.add(state_->clock.now(), seconds);
}

void Metrics::frame_sent(std::size_t bytes) {
    state_->frames.Increment();
    state_->frame_bytes.Increment(static_cast<double>(bytes));
}

void Metrics::message_sent(std::size_t bytes) {
    state_->messages.Increment();
    state_->message_bytes.Increment(static_cast<double>(bytes));
}

void Metrics::message_received(std::size_t bytes) {
    state_->received.Increment();
    state_->received_bytes.Increment(static_cast<double>(bytes));
}

void Metrics::keyframe() {
    state_->keyframes.Increment();
}

void Metrics::catching_up() {
    state_->behind.Increment();
}

void Metrics::frames_dropped(std::uint64_t frames) {
    state_->dropped.Increment(static_cast<double>(frames));
}

void Metrics::reject(Rejection reason) {
    state_->rejected[static_cast<std::size_t>(reason)]->Increment();
}

void Metrics::over_budget(Budgeted kind) {
    state_->over_budget[static_cast<std::size_t>(kind)]->Increment();
}

void Metrics::error(int code) {
    state_->errors.Add({{"code", std::to_string(code)}}).Increment();
}

void Metrics::durable(bool yes) {
    state_->durable.Add({}).Set(yes ? 1.0 : 0.0);
}

std::string Metrics::text(const ServerStatus& status) const {
    Registry now;
    collect(status, now);
    auto families = state_->registry.Collect();
    for (auto& family : now.Collect())
        families.push_back(std::move(family));
    return prometheus::TextSerializer().Serialize(families);
}

Quantiles Metrics::quantiles(Stage stage) const {
    return state_->recent[static_cast<std::size_t>(stage)].quantiles(state_->clock.now());
}

Quantiles Metrics::first_frames() const {
    return state_->recent_first_frames.quantiles(state_->clock.now());
}

Metrics::Totals Metrics::totals() const {
    const State& s = *state_;
    return {whole(s.frames),        whole(s.frame_bytes), whole(s.messages),
            whole(s.message_bytes), whole(s.keyframes),   whole(s.dropped)};
}

} // namespace wakesurf::server
