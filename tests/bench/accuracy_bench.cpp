// The accuracies beside each other, on the same requests at random: a balanced surface has at most 1.3 times the quads of an exact one and takes
// no longer, a fast one neither more quads nor more time than a balanced one.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <benchmark/benchmark.h>

#include <array>

namespace wakesurf::bench {

namespace accuracy_bench {

constexpr double most_quads_ratio = 1.3;
constexpr double most_time_ratio = 1.0;
constexpr int surfaces = 5;
constexpr std::array accuracies{core::Accuracy::Exact, core::Accuracy::Balanced,
                                core::Accuracy::Fast};

struct Request {
    std::shared_ptr<const core::Flow> flow;
    core::Rake rake;
    core::SurfaceParameters parameters;

    /// 0 where there is none: the surface is empty, or too large even when coarse.
    std::size_t quads(core::Accuracy accuracy) const {
        core::SurfaceParameters p = parameters;
        p.accuracy = accuracy;
        p.max_quads = 100'000;
        const auto surface = core::build_surface(*flow, rake, p);
        return surface ? surface->mesh.cells.size() : 0;
    }
};

std::vector<Request> requests_of(const core::AnalyticEntry& entry, core::SurfaceKind kind) {
    std::mt19937 random(16);
    std::vector<Request> all;
    for (int i = 0; i < surfaces; ++i) {
        tests::AskedSurface each = tests::surface_anywhere(entry, kind, 0.05, random);
        all.push_back({std::move(each.flow), each.rake, each.parameters});
    }
    return all;
}

/// From lines in the fluid, a fifth of the domain long, through half of the data.
std::vector<Request> requests_of(const std::shared_ptr<const server::LoadedDataset>& dataset,
                                 core::SurfaceKind kind) {
    const core::Flow& flow = *dataset->flow;
    const core::Box box = flow.domain();
    std::mt19937 random(16);
    const auto part = [&] {
        return 0.1 + 0.8 * static_cast<double>(random()) / std::mt19937::max();
    };
    const auto point = [&] {
        const double x = 0.5 * part(), y = part();
        return core::Vec3(x, y, part());
    };
    std::vector<Request> all;
    while (all.size() < surfaces) {
        const core::Vec3 from = point(), to = glm::mix(from, point(), 0.4);
        const core::Vec3 a = box.lo + box.extent() * from, b = box.lo + box.extent() * to;
        if (flow.status(a) != core::PointStatus::Inside ||
            flow.status(b) != core::PointStatus::Inside)
            continue;
        Request request{dataset->flow, {core::Rake::Kind::Line, {a, b}, 12}, {}};
        const std::vector<double>& times = dataset->info.times;
        request.parameters.kind = kind;
        request.parameters.from = times.front();
        request.parameters.to = 0.5 * (times.front() + times.back());
        request.parameters.separation = 0.04 * glm::length(b - a);
        if (kind == core::SurfaceKind::Time)
            request.parameters.sweep = 0.05 * box.extent();
        all.push_back(std::move(request));
    }
    return all;
}

void compare(benchmark::State& state, const std::vector<Request>& requests) {
    on_one_core([&] {
        std::array<std::size_t, accuracies.size()> quads{};
        std::vector<Turn> turns;
        for (std::size_t i = 0; i < accuracies.size(); ++i)
            turns.push_back([&, i] {
                quads[i] = 0;
                return seconds_of([&] {
                    for (const Request& each : requests)
                        quads[i] += each.quads(accuracies[i]);
                });
            });
        for (auto _ : state) {
            const auto timed = interleave(turns, 3);
            state.counters["balanced_time_ratio"] = timed[1].median / timed[0].median;
            state.counters["fast_time_ratio"] = timed[2].median / timed[1].median;
        }
        const auto ratio = [&](std::size_t i) {
            return static_cast<double>(quads[i]) /
                   static_cast<double>(std::max<std::size_t>(quads[i - 1], 1));
        };
        state.counters["exact_quads"] = static_cast<double>(quads[0]);
        state.counters["balanced_quads_ratio"] = ratio(1);
        state.counters["fast_quads_ratio"] = ratio(2);
        state.counters["most_time_ratio"] = most_time_ratio;
        state.counters["most_quads_ratio"] = most_quads_ratio;
    });
}

template <class Make>
void add(const std::string& name, const Make& make) {
    benchmark::RegisterBenchmark(("accuracies/" + name).c_str(),
                                 [make](benchmark::State& state) { compare(state, make()); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
}

} // namespace accuracy_bench

void register_accuracy_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset) {
    using namespace accuracy_bench;
    for (const auto& [kind, word] : tests::every_kind) {
        for (const core::AnalyticEntry& entry : core::analytic_entries())
            add(std::string(entry.name) + '/' + word,
                [&entry, kind = kind] { return requests_of(entry, kind); });
        if (dataset->info.times.size() > 1)
            add(std::string("data/") + word,
                [dataset, kind = kind] { return requests_of(dataset, kind); });
    }
}

} // namespace wakesurf::bench
