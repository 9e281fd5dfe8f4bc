// A server in a control group of 512 MB beside tenants who take all they are granted: whether it lives, how much memory it
// holds beside what it may, and how long a session with a small surface waits for its edits meanwhile.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/edited_surface.hpp"
#include "tests/bench/load/hostile_tenants.hpp"
#include "tests/bench/load/memory_group.hpp"
#include "tests/bench/support/quantiles.hpp"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

namespace wakesurf::bench {

namespace hostile_bench {

using Clock = std::chrono::steady_clock;

constexpr std::size_t group_bytes = std::size_t{512} << 20;
constexpr double part = 0.6; // what serve takes of a group by itself
constexpr double target_of_budget = 1.1;
constexpr double target_ratio = 3.0;
constexpr int tenants = 6;
constexpr double small_quads = 2'000;
constexpr std::chrono::seconds alone_for{
    60}; // some 450 edits: the 99th percentile of 75 is the slowest
constexpr std::chrono::milliseconds between_edits{100};
constexpr std::chrono::milliseconds look{10};
constexpr std::chrono::seconds hung{60};

/// Ends a connection on which nothing has come for too long: what waits there is told.
class Watchdog {
  public:
    explicit Watchdog(LiveClient& client)
        : thread_([this, &client](const std::stop_token& stop) {
              while (!stop.stop_requested()) {
                  if (Clock::now() - Clock::time_point(Clock::duration(fed_.load())) > hung)
                      client.hang_up();
                  std::this_thread::sleep_for(std::chrono::milliseconds(100));
              }
          }) {}

    void feed() { fed_ = Clock::now().time_since_epoch().count(); }

  private:
    std::atomic<Clock::rep> fed_{Clock::now().time_since_epoch().count()};
    std::jthread thread_;
};

/// Seconds from each edit to the first frame that shows it, and to the whole surface, unless the server had no
/// memory for that.
struct Edits {
    std::vector<double> shown, whole;
    std::size_t refused = 0;
};

Edits edit(EditedSurface& surface, Clock::duration time) {
    Edits times;
    Watchdog watchdog(surface.client());
    std::uint32_t epoch = surface.complete()["epoch"];
    for (const auto end = Clock::now() + time; Clock::now() < end;) {
        const auto start = Clock::now();
        const auto since = [&] {
            return std::chrono::duration<double>(Clock::now() - start).count();
        };
        surface.client().send("rake.set", surface.next_edit());
        epoch = surface.until_frame_after(epoch);
        times.shown.push_back(since());
        try {
            surface.complete();
            times.whole.push_back(since());
        } catch (const std::runtime_error&) {
            ++times.refused;
        }
        watchdog.feed();
        std::this_thread::sleep_for(between_edits);
    }
    return times;
}

/// Throws std::runtime_error if there is no such process.
std::size_t resident_bytes(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/statm");
    std::size_t total = 0, resident = 0;
    if (!(file >> total >> resident) || resident == 0) // 0: it has ended, and was not waited for
        throw std::runtime_error("the server's process has ended");
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// The most memory a process was seen to hold.
class PeakMemory {
  public:
    explicit PeakMemory(pid_t process)
        : thread_([this, process](const std::stop_token& stop) {
              try {
                  for (; !stop.stop_requested(); std::this_thread::sleep_for(look))
                      bytes_ = std::max(bytes_.load(), resident_bytes(process));
              } catch (const std::exception&) {
                  gone_ = true;
              }
          }) {}

    std::size_t bytes() const { return bytes_; }

    bool gone() const { return gone_; }

  private:
    std::atomic<std::size_t> bytes_{0};
    std::atomic<bool> gone_{false};
    std::jthread thread_;
};

void measure(benchmark::State& state, const std::string& dataset, int seconds) {
    const MemoryGroup group(group_bytes);
    std::vector<std::string> arguments{"flow:tornado", dataset, "--log-level", "error"};
    if (!group.there()) {
        std::fprintf(stderr,
                     "hostile: no control group (%s): the server is held by --memory alone\n",
                     group.why().c_str());
        arguments.insert(
            arguments.end(),
            {"--memory", std::to_string(static_cast<std::size_t>(part * group_bytes))});
    }
    const LiveServer server(std::move(arguments), group.launcher());
    EditedSurface light(server.address(), small_quads, 200);
    const auto alone = edit(light, alone_for);
    const double budget = part * static_cast<double>(group_bytes);
    for (auto _ : state) {
        const PeakMemory peak(server.pid());
        Edits beside;
        bool lost = false;
        std::size_t refused = 0, downloads = 0, edits = 0;
        {
            const HostileTenants hostile(server.address(), tenants);
            try {
                beside = edit(light, std::chrono::seconds(seconds));
            } catch (const std::exception& error) {
                std::fprintf(stderr, "hostile: the light session: %s\n", error.what());
                lost = true;
            }
            refused = hostile.refused();
            downloads = hostile.downloads();
            edits = hostile.edits();
        }
        state.SetIterationTime(quantile(beside.shown, 0.99));
        state.counters["killed"] = static_cast<double>(group.killed()) + (peak.gone() ? 1.0 : 0.0);
        state.counters["light_lost"] = lost ? 1.0 : 0.0;
        state.counters["peak_mib"] = static_cast<double>(peak.bytes()) / (1 << 20);
        state.counters["peak_of_budget"] = static_cast<double>(peak.bytes()) / budget;
        state.counters["target_peak_of_budget"] = target_of_budget;
        state.counters["alone_edits"] = static_cast<double>(alone.shown.size());
        state.counters["alone_p50_ms"] = 1e3 * quantile(alone.shown, 0.5);
        state.counters["alone_p99_ms"] = 1e3 * quantile(alone.shown, 0.99);
        state.counters["beside_p50_ms"] = 1e3 * quantile(beside.shown, 0.5);
        state.counters["beside_p99_ms"] = 1e3 * quantile(beside.shown, 0.99);
        state.counters["alone_whole_p99_ms"] = 1e3 * quantile(alone.whole, 0.99);
        state.counters["beside_whole_p50_ms"] = 1e3 * quantile(beside.whole, 0.5);
        state.counters["beside_whole_p99_ms"] = 1e3 * quantile(beside.whole, 0.99);
        state.counters["light_edits"] = static_cast<double>(beside.shown.size());
        state.counters["light_refused"] = static_cast<double>(beside.refused);
        state.counters["ratio_p99"] = quantile(beside.shown, 0.99) / quantile(alone.shown, 0.99);
        state.counters["target_ratio_p99"] = target_ratio;
        state.counters["hostile_edits"] = static_cast<double>(edits);
        state.counters["downloads"] = static_cast<double>(downloads);
        state.counters["refused"] = static_cast<double>(refused);
    }
}

} // namespace hostile_bench

void register_hostile_benchmark(const std::string& dataset, int seconds) {
    using namespace hostile_bench;
    benchmark::RegisterBenchmark(
        "hostile/tenants",
        [dataset, seconds](benchmark::State& state) { measure(state, dataset, seconds); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace wakesurf::bench
