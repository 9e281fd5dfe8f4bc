#include "core/base/vec3.hpp"
#include "protocol/mesh_frame.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/live_server.hpp"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace wakesurf::bench {

namespace {

using nlohmann::json;
constexpr double target_ms = 20;

/// A session with a stream surface of about 20,000 quads, and a rake to move back and forth.
class EditSession {
  public:
    explicit EditSession(const std::string& dataset)
        : server_(dataset), client_(server_.address()) {
        const std::string id = ready_dataset();
        const json info = client_.call("dataset.describe", {{"dataset", id}});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low_[static_cast<int>(axis)] = info["bounds"][2 * axis];
            size_[static_cast<int>(axis)] =
                info["bounds"][2 * axis + 1].get<double>() - low_[static_cast<int>(axis)];
        }
        session_ = client_.call("session.create", {{"name", "bench"}})["session"];
        client_.call("session.join", {{"session", session_}, {"name", "bench"}});
        rake_ = client_.call("rake.set", rake(0.0))["rake"];
        const double from = info["times"][0];
        double separation = std::max({size_.x, size_.y, size_.z}) / 200.0;
        for (int i = 0; i < 6; ++i) { // settles on about 20,000 quads whatever the dataset
            json surface{{"rake", rake_},          {"kind", "stream"},  {"dataset", id},
                         {"from", from},           {"to", from + 20.0}, {"separation", separation},
                         {"fields", json::array()}};
            if (!surface_.empty())
                surface["surface"] = surface_;
            surface_ = client_.call("surface.set", surface)["surface"];
            const json stats =
                client_.call("surface.wait", {{"surface", surface_}, {"timeoutMs", 60'000}});
            quads_ = stats["quads"];
            separation *= std::sqrt(quads_ / 20'000.0);
        }
        client_.call("surface.subscribe", {{"surface", surface_}});
    }

    /// Seconds from sending an edit to holding the first frame of its epoch.
    double edit() {
        // Waits for the previous surface, so that each edit meets an idle server and the next one a busy one.
        const json before =
            client_.call("surface.wait", {{"surface", surface_}, {"timeoutMs", 60'000}});
        phase_ += 0.1;
        const auto start = std::chrono::steady_clock::now();
        client_.send("rake.set", rake(phase_));
        return until_frame_after(before["epoch"], start);
    }

    /// The same, with the server in the middle of the previous edit's surface.
    double edit_while_busy() {
        const json before =
            client_.call("surface.wait", {{"surface", surface_}, {"timeoutMs", 60'000}});
        phase_ += 0.1;
        const std::uint32_t first = before["epoch"].get<std::uint32_t>();
        client_.send("rake.set", rake(phase_));
        until_frame_after(first, {}); // the coarse surface is out, the fine one is being computed
        phase_ += 0.1;
        const auto start = std::chrono::steady_clock::now();
        client_.send("rake.set", rake(phase_));
        return until_frame_after(first + 1, start);
    }

    double quads() const { return quads_; }

  private:
    /// The server's only dataset, once its import is done.
    std::string ready_dataset() {
        for (int i = 0; i < 3000; ++i) {
            const json entry = client_.call("dataset.list", json::object())["datasets"][0];
            if (entry["state"] == "ready")
                return entry["dataset"];
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        throw std::runtime_error("the dataset was not imported within a minute");
    }

    double until_frame_after(std::uint32_t epoch, std::chrono::steady_clock::time_point start) {
        for (;;) {
            const protocol::Bytes bytes = client_.next_frame();
            if (const auto frame = protocol::read_frame(bytes);
                frame && frame->header.epoch > epoch)
                return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
                    .count();
        }
    }

    json rake(double phase) const {
        const double y = 0.40 + 0.02 * std::sin(phase);
        const auto point = [&](double z) {
            const core::Vec3 p = low_ + size_ * core::Vec3(0.245, y, z);
            return json{p.x, p.y, p.z};
        };
        json record{{"kind", "line"}, {"points", {point(0.05), point(0.95)}}, {"seeds", 32}};
        if (!rake_.empty())
            record["rake"] = rake_;
        return record;
    }

    LiveServer server_;
    LiveClient client_;
    core::Vec3 low_{0.0}, size_{0.0};
    std::string session_, rake_, surface_;
    double quads_ = 0.0;
    double phase_ = 0.0;
};

using Measure = double (EditSession::*)();

void measure(benchmark::State& state, const std::string& dataset, Measure one) {
    EditSession session(dataset);
    std::vector<double> times;
    for (auto _ : state) {
        const double seconds = (session.*one)();
        times.push_back(seconds);
        state.SetIterationTime(seconds);
    }
    std::sort(times.begin(), times.end());
    state.counters["median_ms"] = 1e3 * times[times.size() / 2];
    state.counters["p95_ms"] = 1e3 * times[times.size() * 95 / 100];
    state.counters["quads"] = session.quads();
    state.counters["target_ms"] = target_ms;
}

} // namespace

void register_edit_benchmark(const std::string& dataset) {
    const auto add = [&](const char* name, Measure one) {
        benchmark::RegisterBenchmark(
            name, [dataset, one](benchmark::State& state) { measure(state, dataset, one); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(60);
    };
    add("edit_to_first_frame/idle", &EditSession::edit);
    add("edit_to_first_frame/busy", &EditSession::edit_while_busy);
}

} // namespace wakesurf::bench
