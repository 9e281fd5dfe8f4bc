#include "tests/bench/benchmarks.hpp"
#include "tests/bench/edited_surface.hpp"
#include "tests/bench/load/process_usage.hpp"
#include "tests/bench/load/swarm.hpp"
#include "tests/bench/support/quantiles.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <map>
#include <set>
#include <thread>
#include <utility>

namespace wakesurf::bench {

namespace load_bench {

using Clock = std::chrono::steady_clock;

constexpr std::size_t viewers = 500;
constexpr double quads =
    560; ///< of the surface: an edit's states, coarse and final, are about 11 KiB together
constexpr int edits = 100;
constexpr std::chrono::milliseconds between_edits{100};

/// A session that many look at, with a surface of some KiB a state.
struct Audience {
    explicit Audience(const std::string& dataset)
        : server(dataset), surface(server.address(), quads),
          swarm(server.address(), {surface.session(), surface.surface()}) {}

    LiveServer server;
    EditedSurface surface;
    Swarm swarm;
};

using Edits = std::map<std::uint32_t, Clock::time_point>;

/// At 10 Hz; when each was sent, by its epoch.
Edits edit_often(Audience& audience, int count) {
    Edits sent;
    auto next = Clock::now();
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_until(next);
        next += between_edits;
        const auto start = Clock::now();
        const auto answer =
            audience.surface.client().call("rake.set", audience.surface.next_edit());
        sent[answer["surfaces"][0]["epoch"]] = start;
    }
    audience.surface.complete();
    std::this_thread::sleep_for(between_edits); // what is still on its way
    return sent;
}

/// Seconds from an edit to each viewer's first whole state of it. Viewers from `others` on are not counted.
std::vector<double> edit_for_all(Audience& audience, std::size_t others) {
    const Edits sent = edit_often(audience, edits);
    std::vector<double> times;
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (const Arrival& arrival : audience.swarm.take_arrivals()) {
        const auto edit = sent.find(arrival.epoch);
        if (edit != sent.end() && arrival.viewer < others &&
            seen.emplace(arrival.viewer, arrival.epoch).second)
            times.push_back(std::chrono::duration<double>(arrival.at - edit->second).count());
    }
    return times;
}

void report(benchmark::State& state, const std::vector<double>& times, double target_p99_ms) {
    state.counters["p50_ms"] = 1e3 * quantile(times, 0.5);
    state.counters["p99_ms"] = 1e3 * quantile(times, 0.99);
    state.counters["arrived_part"] =
        static_cast<double>(times.size()) / static_cast<double>(viewers * edits);
    state.counters["target_p99_ms"] = target_p99_ms;
}

void fan_out(benchmark::State& state, const std::string& dataset) {
    for (auto _ : state) {
        Audience audience(dataset);
        edit_often(audience, edits / 4); // what edits take is not the viewers'
        const auto alone = usage_of(audience.server.process());
        audience.swarm.connect(viewers);
        const auto full = usage_of(audience.server.process());
        audience.swarm.take_arrivals();
        audience.swarm.take_bytes();
        const auto start = Clock::now();
        const auto times = edit_for_all(audience, viewers);
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        const auto after = usage_of(audience.server.process());
        state.SetIterationTime(quantile(times, 0.99));
        report(state, times, 25);
        state.counters["kib_an_edit"] = static_cast<double>(audience.swarm.take_bytes()) / 1024.0 /
                                        static_cast<double>(viewers * edits);
        state.counters["cores"] = (after.processor_seconds - full.processor_seconds) / seconds;
        state.counters["kb_a_viewer"] = (static_cast<double>(after.resident_bytes) -
                                         static_cast<double>(alone.resident_bytes)) /
                                        1e3 / viewers;
        state.counters["target_cores"] = 0.5;
        state.counters["target_kb_a_viewer"] = 32;
    }
}

void fan_out_with_slow(benchmark::State& state, const std::string& dataset) {
    for (auto _ : state) {
        Audience audience(dataset);
        audience.swarm.connect(viewers);
        audience.swarm.connect(1, {.stalled = true});
        audience.swarm.connect(10, {.bytes_per_second = 125'000}); // 1 Mbit/s
        audience.swarm.take_arrivals();
        const auto times = edit_for_all(audience, viewers);
        state.SetIterationTime(quantile(times, 0.99));
        report(state, times, 40);
    }
}

void storm(benchmark::State& state, const std::string& dataset) {
    for (auto _ : state) {
        Audience audience(dataset);
        audience.swarm.connect(1000);
        const double seconds = audience.swarm.storm();
        state.SetIterationTime(seconds);
        state.counters["target_s"] = 5;
    }
}

void idle(benchmark::State& state, const std::string& dataset) {
    for (auto _ : state) {
        Audience audience(dataset);
        const auto before = usage_of(audience.server.process());
        audience.swarm.connect_idle(1000);
        const auto after = usage_of(audience.server.process());
        state.SetIterationTime(1e-9);
        state.counters["mb"] = (static_cast<double>(after.resident_bytes) -
                                static_cast<double>(before.resident_bytes)) /
                               1e6;
        state.counters["target_mb"] = 20;
    }
}

} // namespace load_bench

void register_load_benchmarks(const std::string& dataset) {
    using namespace load_bench;
    const auto add = [&](const char* name, void (*measure)(benchmark::State&, const std::string&)) {
        benchmark::RegisterBenchmark(
            name, [dataset, measure](benchmark::State& state) { measure(state, dataset); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    };
    add("load/500_viewers", fan_out);
    add("load/500_viewers_beside_slow_ones", fan_out_with_slow);
    add("load/1000_reconnect", storm);
    add("load/1000_idle", idle);
}

} // namespace wakesurf::bench
