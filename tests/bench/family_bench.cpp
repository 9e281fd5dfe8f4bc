// A family of stream surfaces: every node of a grid traced to where the scalar is given.
#include "core/surface/family/family_trace.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/sampled_flows.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace family_bench {

core::FamilyField traced(const SampledFlow& sampled, const core::FamilyRequest& request) {
    std::vector<core::Vec3> some;
    for (std::size_t i = 0; i < sampled.grid.nodes(); i += 997)
        some.push_back(core::node_position(sampled.grid, i));
    auto field = core::plan_family(*sampled.flow, request, 0.0, some, {})
                     .and_then([&](const core::FamilyPlan& plan) {
                         return core::trace_family(*sampled.flow, sampled.grid, plan, {}, {});
                     });
    if (!field)
        throw std::runtime_error(field.error().message);
    return std::move(*field);
}

void trace(benchmark::State& state, const core::FamilyRequest& request, bool one_core) {
    const SampledFlow& sampled = sampled_abc();
    core::FamilyCounts counts;
    double seconds = 0.0;
    for (auto _ : state) {
        const auto work = [&] { counts = traced(sampled, request).counts; };
        const auto began = std::chrono::steady_clock::now();
        if (one_core)
            on_one_core(work);
        else
            work();
        seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        state.SetIterationTime(seconds);
    }
    state.counters["nodes_per_second"] = static_cast<double>(counts.nodes) / seconds;
    state.counters["reached_percent"] =
        100.0 * static_cast<double>(counts.reached) / static_cast<double>(counts.nodes);
}

} // namespace family_bench

void register_family_benchmarks() {
    const core::Rake curve{core::Rake::Kind::Line, {{1.0, 0.5, 3.0}, {5.0, 0.5, 3.5}}};
    for (const bool one_core : {true, false}) {
        const std::string cores = one_core ? "/one_core" : "/all_cores";
        const auto add = [&](const std::string& name, const core::FamilyRequest& request) {
            benchmark::RegisterBenchmark(
                ("family/" + name + cores).c_str(),
                [=](benchmark::State& state) { family_bench::trace(state, request, one_core); })
                ->Iterations(1)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        };
        add("inflow", {core::FamilyInflow{}, "y"});
        add("curve", {curve});
    }
}

} // namespace wakesurf::bench
