#include "tests/bench/benchmarks.hpp"
#include "tests/bench/edited_surface.hpp"
#include "tests/bench/load/swarm.hpp"
#include "tests/bench/support/quantiles.hpp"
#include "tests/support/server/delaying_proxy.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace wakesurf::bench {

namespace remote_drag_bench {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds one_way{50};
constexpr std::chrono::seconds drag{60};
constexpr std::chrono::microseconds between_moves{16'667};
constexpr double quads = 20'000;
constexpr double target_ms = 160;
constexpr std::size_t part = 600; ///< moves of the first and the last ten seconds

/// Seconds from each move to the first surface on the other side that is of this move or a later one.
std::vector<double> drag_far_away(const std::string& dataset) {
    const LiveServer server(dataset);
    EditedSurface surface(server.address(), quads);
    tests::DelayingProxy line(static_cast<std::uint16_t>(std::stoi(server.address().port)),
                              {.delay = one_way});
    ServerAddress far = server.address();
    far.port = std::to_string(line.port());
    Swarm person(far, {surface.session(), surface.surface()});
    person.connect(1);
    const std::uint32_t before = surface.complete()["epoch"];
    person.take_arrivals();

    std::vector<Clock::time_point> moved;
    auto next = Clock::now();
    for (const auto end = next + drag; next < end; next += between_moves) {
        std::this_thread::sleep_until(next);
        moved.push_back(Clock::now());
        person.send(0, "rake.set", surface.next_edit());
    }
    std::this_thread::sleep_for(10 * one_way);

    std::vector<double> times;
    const auto arrivals = person.take_arrivals();
    auto shown = arrivals.begin();
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const auto of_this = [epoch = before + i + 1](const Arrival& each) {
            return each.epoch >= epoch;
        };
        shown = std::find_if(shown, arrivals.end(), of_this);
        if (shown == arrivals.end())
            break;
        times.push_back(std::chrono::duration<double>(shown->at - moved[i]).count());
    }
    return times;
}

void measure(benchmark::State& state, const std::string& dataset) {
    for (auto _ : state) {
        const auto times = drag_far_away(dataset);
        if (times.size() < 2 * part)
            return state.SkipWithError("hardly any surface of the drag arrived");
        const std::vector<double> first(times.begin(), times.begin() + part);
        const std::vector<double> last(times.end() - part, times.end());
        state.SetIterationTime(quantile(times, 0.5));
        state.counters["p50_ms"] = 1e3 * quantile(times, 0.5);
        state.counters["p99_ms"] = 1e3 * quantile(times, 0.99);
        state.counters["growth"] = quantile(last, 0.5) / quantile(first, 0.5);
        state.counters["target_p50_ms"] = target_ms;
    }
}

} // namespace remote_drag_bench

void register_remote_drag_benchmark(const std::string& dataset) {
    using namespace remote_drag_bench;
    benchmark::RegisterBenchmark("drag_over_100_ms",
                                 [dataset](benchmark::State& state) { measure(state, dataset); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace wakesurf::bench
