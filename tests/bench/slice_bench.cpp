// A plane that is dragged through a field of 128^3 values, 30 places one after the other, each to its raster: coarse, as while it is
// dragged, and as fine as a screen of 1280 x 800, as when it stands still.
#include "core/surface/slice/slice_raster.hpp"
#include "store/store_scalars.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/quantiles.hpp"
#include "tests/support/scalar_store.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace wakesurf::bench {

namespace slice_bench {

constexpr std::uint32_t nodes = 128;
constexpr int places = 30;
constexpr double target_ms = 80.0;
constexpr std::size_t coarse_samples = 320;
constexpr std::size_t fine_samples = 1280;

/// As wide and high as the screen.
core::UniformGrid box() {
    return {core::Vec3(0.0), core::Vec3(1.6, 1.0, 1.0) / double(nodes - 1), {nodes, nodes, nodes}};
}

double wave(const core::Vec3& x, double time) {
    return std::sin(9.0 * x.x + time) + std::cos(7.0 * x.y) * std::sin(5.0 * x.z);
}

/// Returns the milliseconds of each slice across z, between two stored times.
std::vector<double>
dragged(const core::Flow& flow, const core::SampledField& field, std::size_t samples) {
    std::vector<double> out;
    for (int i = 0; i < places; ++i) {
        const double z = (i + 0.5) / places;
        const auto start = std::chrono::steady_clock::now();
        const auto raster =
            core::sample_slice({{{0.8, 0.5, z}, {0, 0, 1}}, field, 0.4, samples}, flow, {});
        if (!raster)
            throw std::runtime_error(raster.error().message);
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - start;
        out.push_back(took.count());
    }
    return out;
}

void measure(benchmark::State& state) {
    const tests::ScalarStore store(box(), {0.0, 1.0}, {{"f", wave}});
    const auto scalars =
        store::StoreScalars::open(store.reader(), std::make_shared<core::PosixDisk>());
    const std::array<std::pair<const char*, core::SampledField>, 3> fields{
        std::pair{"speed", core::SampledField(core::SpeedField{})},
        std::pair{"scalar", core::SampledField(core::StoredScalar{scalars.get(), 0})},
        std::pair{"vorticity", core::SampledField(core::GradientField::Vorticity)}};
    for (const auto& [name, field] : fields) // loads what is sampled
        dragged(*store.flow(), field, 32);
    for (auto _ : state)
        for (const auto& [name, field] : fields) {
            const auto coarse = dragged(*store.flow(), field, coarse_samples);
            const auto fine = dragged(*store.flow(), field, fine_samples);
            state.counters[std::string(name) + "_coarse_ms"] = quantile(coarse, 0.5);
            state.counters[std::string(name) + "_coarse_worst_ms"] = quantile(coarse, 1.0);
            state.counters[std::string(name) + "_fine_ms"] = quantile(fine, 0.5);
            state.SetIterationTime(quantile(fine, 0.5) / 1e3);
        }
    state.counters["target_ms"] = target_ms;
}

} // namespace slice_bench

void register_slice_benchmark() {
    benchmark::RegisterBenchmark("slices/128", slice_bench::measure)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

} // namespace wakesurf::bench
