// Velocities at many points at one time: by the kernel, beside sample(), which computes each in double; and
// out of advancing.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/particle_sets.hpp"
#include "tests/bench/support/sampled_flows.hpp"

#include <benchmark/benchmark.h>

#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace sampling_bench {

constexpr int repetitions = 9;
constexpr double target_smooth_million_per_second = 4.0;

void demand(bool done) {
    if (!done)
        throw std::runtime_error("the flow could not be sampled");
}

void sample(benchmark::State& state, bool smooth) {
    const SampledFlow& sampled = sampled_abc();
    const std::vector<core::Vec3> places = front_particles(sampled.grid);
    const double time = 0.4 * sampled.interval;
    const std::vector<double> times(places.size(), time);
    std::vector<core::Vec3> exact(places.size());
    std::vector<core::Vec3f> fast(places.size());
    const auto on_one = [](const auto& work) {
        return on_one_core([&] { return seconds_of([&] { demand(work()); }); });
    };
    for (auto _ : state) {
        const std::vector<Timed> taken = interleave(
            {[&] {
                 return on_one([&] {
                     return sampled.flow->sample_at(places, time, fast, {}, smooth).has_value();
                 });
             },
             [&] {
                 return on_one([&] {
                     return sampled.flow->sample(places, times, exact, {}, smooth).has_value();
                 });
             }},
            repetitions);
        const double millions = 1e-6 * static_cast<double>(places.size());
        state.SetIterationTime(taken[0].median);
        state.counters["million_samples_per_second"] = millions / taken[0].median;
        state.counters["in_double_million_per_second"] = millions / taken[1].median;
        if (smooth)
            state.counters["target_million_per_second"] = target_smooth_million_per_second;
    }
}

/// A frame of a moving surface: two steps with tangents, and velocity where they end.
void arrive(benchmark::State& state) {
    const SampledFlow& sampled = sampled_abc();
    CarriedParticles particles(front_particles(sampled.grid), true);
    const std::size_t count = particles.start().size();
    std::vector<core::Vec3f> velocity(count);
    std::vector<std::uint8_t> written(count);
    core::AdvanceOptions options;
    options.step = 0.1 * sampled.interval;
    const double to = 2.0 * options.step;
    const auto frame = [&](bool out_of_advancing, bool afterwards) {
        core::Particles carried = particles.restart();
        std::fill(written.begin(), written.end(), std::uint8_t{0});
        if (out_of_advancing) {
            carried.velocity = velocity;
            carried.sampled = written;
        }
        return on_one_core([&] {
            return seconds_of([&] {
                demand(sampled.flow->advance(carried, to, options, {}).has_value());
                if (afterwards)
                    demand(sampled.flow->sample_at(particles.position(), to, velocity, {})
                               .has_value());
            });
        });
    };
    for (auto _ : state) {
        const std::vector<Timed> taken =
            interleave({[&] { return frame(true, false); }, [&] { return frame(false, false); },
                        [&] { return frame(false, true); }},
                       repetitions);
        const auto nanoseconds = [&](double seconds) {
            return 1e9 * seconds / static_cast<double>(count);
        };
        state.SetIterationTime(taken[0].median);
        state.counters["frame_ns_a_particle"] = nanoseconds(taken[0].median);
        state.counters["velocity_ns"] = nanoseconds(taken[0].median - taken[1].median);
        state.counters["velocity_afterwards_ns"] = nanoseconds(taken[2].median - taken[1].median);
    }
}

} // namespace sampling_bench

void register_sampling_benchmarks() {
    using namespace sampling_bench;
    const auto add = [](const char* name, const auto& run) {
        benchmark::RegisterBenchmark((std::string("sampling/abc/front") + name).c_str(), run)
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    };
    add("", [](benchmark::State& state) { sample(state, false); });
    add("/smooth", [](benchmark::State& state) { sample(state, true); });
    add("/out_of_advancing", [](benchmark::State& state) { arrive(state); });
}

} // namespace wakesurf::bench
