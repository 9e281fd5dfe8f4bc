// What is left of the error between stored times with cubic interpolation and along the flow, beside linear: closed
// forms that are stored on a grid 6 to 24 times a period, and 384 for the truth, so that the grid is the same in all.
// And what they cost, on a grid and in cells.
#include "core/field/stored_flow.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/quantiles.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <numbers>
#include <stdexcept>

namespace wakesurf::bench {

namespace between_bench {

using core::Between;
using core::Vec3;
constexpr double pi = std::numbers::pi;
constexpr int dense = 384; ///< stored times a period, for the truth

struct StoredForm {
    const char* name;
    tests::SampledSource::Velocity velocity;
    core::UniformGrid grid;
    Vec3 begin, end; ///< of the line that particles leave
    double period, until;
};

core::UniformGrid grid(const Vec3& low, const Vec3& high, std::array<std::uint32_t, 3> nodes) {
    core::UniformGrid out;
    out.origin = low;
    out.dimensions = nodes;
    out.spacing = (high - low) / (Vec3(nodes[0], nodes[1], nodes[2]) - 1.0);
    return out;
}

/// Vortices of alternating sign, each carried along at 0.8.
Vec3 street(const Vec3& p, double t) {
    Vec3 u(1.0, 0.0, 0.1);
    for (int i = -3; i < 9; ++i) {
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        const double x = p.x - (0.8 * t - 2.5 * i + 8.0), y = p.y - 0.4 * sign;
        const double square = x * x + y * y + 1e-9;
        const double turn = sign * 0.9 * (1.0 - std::exp(-square / 0.16)) / square;
        u += turn * Vec3(y, -x, 0.0);
    }
    return u;
}

std::vector<StoredForm> forms() {
    return {
        {"double_gyre",
         [](const Vec3& p, double t) {
             const double a = 0.25 * std::sin(2 * pi * t / 10.0), b = 1.0 - 2.0 * a;
             const double f = a * p.x * p.x + b * p.x, df = 2.0 * a * p.x + b;
             return 0.1 * pi *
                    Vec3(-std::sin(pi * f) * std::cos(pi * p.y),
                         std::cos(pi * f) * std::sin(pi * p.y) * df, 0.05);
         },
         grid({0, 0, -1}, {2, 1, 2}, {81, 41, 4}),
         {0.2, 0.2, 0},
         {1.8, 0.8, 0},
         10.0,
         15.0},
        {"abc",
         [](const Vec3& p, double t) {
             const double a = std::sqrt(3.0) + 0.125 * t * std::sin(pi * t), b = std::sqrt(2.0),
                          c = 1.0 + 0.3 * std::sin(2.0 * t);
             return 0.4 * Vec3(a * std::sin(p.z) + c * std::cos(p.y),
                               b * std::sin(p.x) + a * std::cos(p.z),
                               c * std::sin(p.y) + b * std::cos(p.x));
         },
         grid({-6, -6, -6}, {10, 10, 10}, {61, 61, 61}),
         {1, 2, 3},
         {4, 3, 3.5},
         2.0,
         5.0},
        {"wavy_wake",
         [](const Vec3& p, double t) {
             const double phase = 1.3 * (p.x - 0.8 * t), decay = std::exp(-p.y * p.y);
             return Vec3(1.0 + 0.3 * std::tanh(p.y / 0.3) + 0.25 * std::cos(phase) * decay,
                         0.4 * std::sin(phase) * decay,
                         0.1 * std::sin(0.7 * p.x - 2.0 * pi / 6.0 * t));
         },
         grid({-2, -4, -3}, {16, 4, 3}, {181, 81, 5}),
         {0, -1, 0},
         {0, 1, 0},
         2.0 * pi / 1.04,
         10.0},
        {"vortex_street",
         street,
         grid({-4, -3, -1}, {20, 3, 3}, {241, 91, 4}),
         {0, -0.8, 0},
         {0, 0.8, 0},
         6.25,
         12.0},
        {"standing_wave",
         [](const Vec3& p, double t) {
             const double c = 0.5 * std::cos(2.0 * t);
             return Vec3(0.4 + c * std::sin(1.5 * p.x) * std::cos(1.5 * p.y),
                         -c * std::cos(1.5 * p.x) * std::sin(1.5 * p.y), 0.1);
         },
         grid({-2, -3, -1}, {6, 3, 2}, {101, 76, 4}),
         {0, -1, 0},
         {0, 1, 0},
         pi,
         6.0},
        {"stokes_layer", // a wall at rest under a fluid that swings
         [](const Vec3& p, double t) {
             const double y = std::max(p.y, 0.0) / 0.3;
             return Vec3(std::cos(2.0 * t) - std::exp(-y) * std::cos(2.0 * t - y) + 0.09 * y,
                         0.0045 * y * y * std::sin(p.x - t), 0.1);
         },
         grid({-4, 0, -1}, {8, 3, 2}, {121, 121, 4}),
         {0, 0.05, 0},
         {0, 1.5, 0},
         pi,
         6.0},
    };
}

template <class T>
T need(core::Result<T> result) {
    if (!result)
        throw std::runtime_error(result.error().message);
    return std::move(*result);
}

std::shared_ptr<const core::Flow> stored(const StoredForm& form, int per_period) {
    std::vector<double> times;
    for (int k = 0; times.empty() || times.back() < form.until; ++k)
        times.push_back(form.period * k / per_period);
    core::TimeStepCache::Options all;
    all.budget_bytes = std::size_t{6} << 30;
    return core::make_stored_flow(std::make_shared<core::TimeStepCache>(
        std::make_shared<tests::SampledSource>(form.grid, std::move(times), form.velocity), all));
}

/// Where particles come to that leave a line all the time; not a number: out of the domain.
std::vector<Vec3> carried(const core::Flow& flow, const StoredForm& form) {
    constexpr int along = 30, releases = 30;
    std::vector<Vec3> place;
    std::vector<double> time;
    for (int r = 0; r < releases; ++r)
        for (int i = 0; i < along; ++i) {
            place.push_back(form.begin + (form.end - form.begin) * (i / (along - 1.0)));
            time.push_back(0.95 * form.until * r / (releases - 1.0));
        }
    std::vector<core::CurveEnd> end(place.size(), core::CurveEnd::Running);
    core::AdvanceOptions options;
    options.step = form.period / 100.0;
    need(flow.advance({place, {}, {}, time, end}, form.until, options, {}));
    for (std::size_t i = 0; i < place.size(); ++i)
        if (end[i] != core::CurveEnd::Running)
            place[i] = Vec3(std::nan(""));
    return place;
}

void compare(benchmark::State& state, const StoredForm& form) {
    for (auto _ : state) {
        const std::vector<Vec3> truth = carried(*stored(form, dense), form);
        for (const int per_period : {6, 12, 24}) {
            const auto linear = stored(form, per_period);
            std::array<std::array<double, 3>, 3> off{};
            for (const Between between : {Between::Linear, Between::Cubic, Between::Flow}) {
                const auto here = carried(*linear->interpolated(between), form);
                std::vector<double> distance;
                for (std::size_t i = 0; i < here.size(); ++i)
                    if (const double d = glm::length(here[i] - truth[i]); !std::isnan(d))
                        distance.push_back(d);
                const std::array parts{0.5, 0.9, 0.99};
                for (std::size_t q = 0; q < parts.size(); ++q)
                    off[static_cast<std::size_t>(between)][q] = quantile(distance, parts[q]);
            }
            const std::array names{"p50", "p90", "p99"};
            for (std::size_t q = 0; q < names.size(); ++q) {
                const std::string at =
                    std::string("_") + names[q] + "_" + std::to_string(per_period);
                state.counters["linear" + at] = off[0][q];
                state.counters["cubic_part" + at] = off[1][q] / off[0][q];
                state.counters["flow_part" + at] = off[2][q] / off[0][q];
            }
        }
        state.counters["target_flow_part_p50"] = 1.05;
        state.counters["target_flow_part_p90"] = 0.6;
    }
}

core::CellMesh in_hexahedra(const core::UniformGrid& grid) {
    const auto& n = grid.dimensions;
    return tests::block({n[0] - 1, n[1] - 1, n[2] - 1}, [&](const Vec3& part) {
        return grid.bounds().lo + grid.bounds().extent() * part;
    });
}

/// The processor time to carry 4,000 particles through the street for a period, beside the same linearly.
void cost(benchmark::State& state, bool in_cells) {
    const core::UniformGrid box = grid({-4, -3, -1}, {20, 3, 3}, {121, 46, 21});
    std::vector<double> times;
    for (int k = 0; k <= 12; ++k)
        times.push_back(6.25 * k / 12);
    const auto source = std::make_shared<tests::SampledSource>(
        in_cells ? core::Grid(in_hexahedra(box)) : core::Grid(box), times, street);
    const auto flow = core::make_stored_flow(
        std::make_shared<core::TimeStepCache>(source, core::TimeStepCache::Options{}));
    const auto seconds = [&](Between between, core::AdvanceOptions::Method method) {
        const auto here = flow->interpolated(between);
        double best = 1e300;
        for (int turn = 0; turn < 4; ++turn) {
            std::vector<Vec3> place;
            for (int i = 0; i < 4000; ++i)
                place.emplace_back(0.1 * (i % 50), -2.0 + 0.05 * (i / 50), 0.5 + 0.01 * (i % 50));
            std::vector<double> time(place.size(), 0.0);
            std::vector<core::CurveEnd> end(place.size(), core::CurveEnd::Running);
            core::AdvanceOptions options;
            options.method = method;
            options.step = 0.1;
            options.tolerance = 1e-5;
            options.longest_step = 0.2;
            const std::clock_t start =
                std::clock(); // of all threads: other programs may run beside
            need(here->advance({place, {}, {}, time, end}, 6.25, options, {}));
            if (turn > 0) // the first loads
                best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        }
        return best;
    };
    using Method = core::AdvanceOptions::Method;
    for (auto _ : state) {
        const Method usual =
            in_cells ? Method::Dopri5 : Method::Rk4; // what balanced surfaces ask for
        const double linear = seconds(Between::Linear, usual);
        state.counters["linear"] = linear;
        state.counters["linear_rk4"] = seconds(Between::Linear, Method::Rk4) / linear;
        state.counters["cubic"] = seconds(Between::Cubic, Method::Rk4) / linear;
        state.counters["flow"] = seconds(Between::Flow, Method::Rk4) / linear;
        state.counters["flow_controlled"] = seconds(Between::Flow, Method::Dopri5) / linear;
        state.counters["target_flow"] = in_cells ? 1.6 : 2.5;
    }
}

} // namespace between_bench

void register_between_benchmarks() {
    using namespace between_bench;
    for (const StoredForm& form : forms())
        benchmark::RegisterBenchmark((std::string("between/") + form.name).c_str(),
                                     [form](benchmark::State& state) { compare(state, form); })
            ->Unit(benchmark::kSecond)
            ->Iterations(1);
    for (const bool in_cells : {false, true})
        benchmark::RegisterBenchmark(in_cells ? "between/cost/cells" : "between/cost/grid",
                                     [in_cells](benchmark::State& state) { cost(state, in_cells); })
            ->Unit(benchmark::kSecond)
            ->Iterations(1);
}

} // namespace wakesurf::bench
