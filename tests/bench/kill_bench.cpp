#include "tests/bench/benchmarks.hpp"
#include "tests/support/server/killed_server.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace kill_bench {

constexpr int kills = 200;
constexpr int sessions = 60;
constexpr int surfaces = 8;
constexpr int restarts = 10;
constexpr double target_ready_ms = 1000;

/// A folder that goes with the benchmark.
class Folder {
  public:
    Folder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "wakesurf-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
    }

    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

void report(benchmark::State& state, std::vector<double> ready_ms) {
    std::sort(ready_ms.begin(), ready_ms.end());
    state.SetIterationTime(ready_ms.back() / 1e3);
    state.counters["median_ready_ms"] = ready_ms[ready_ms.size() / 2];
    state.counters["longest_ready_ms"] = ready_ms.back();
    state.counters["target_ready_ms"] = target_ready_ms;
}

void kill_under_edits(benchmark::State& state) {
    for (auto _ : state) {
        const Folder folder;
        const tests::KillReport found = tests::kill_under_edits(folder.path(), 1, kills);
        for (const std::string& each : found.wrong)
            std::fprintf(stderr, "%s\n", each.c_str());
        report(state, found.ready_ms);
        state.counters["kills"] = found.kills;
        state.counters["answered_edits"] = static_cast<double>(found.answered);
        state.counters["lost"] = static_cast<double>(found.wrong.size());
    }
}

void restart(benchmark::State& state) {
    for (auto _ : state) {
        const Folder folder;
        report(state, tests::restart_with_sessions(folder.path(), sessions, surfaces, restarts));
        state.counters["sessions"] = sessions;
        state.counters["surfaces"] = sessions * surfaces;
    }
}

} // namespace kill_bench

void register_kill_benchmarks() {
    using namespace kill_bench;
    const auto add = [](const char* name, void (*measure)(benchmark::State&)) {
        benchmark::RegisterBenchmark(name, measure)
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    };
    add("kill9/under_edits", kill_under_edits);
    add("kill9/restart_with_60_sessions", restart);
}

} // namespace wakesurf::bench
