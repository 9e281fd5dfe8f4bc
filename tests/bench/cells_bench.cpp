#include "core/dataset/cell_neighbours.hpp"
#include "core/field/cells/cell_sampler.hpp"
#include "core/surface/moving/moving_surface.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/vtk/cell_field.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/meshed_source.hpp"

#include <benchmark/benchmark.h>

#include <memory>
#include <random>
#include <stdexcept>

namespace wakesurf::bench {

namespace cells_bench {

using core::Vec3;

constexpr int repetitions = 7;
constexpr int particles = 400;
constexpr int steps = 500;
constexpr double target_vertex_step_ns = 350.0;

/// Potential flow round a cylinder of radius 1/2, with a swing along it.
Vec3 round_it(const Vec3& p) {
    const double r2 = std::max(0.25, p.x * p.x + p.y * p.y);
    const double part = 0.25 / (r2 * r2);
    return {1.0 - part * (p.x * p.x - p.y * p.y), -2.0 * part * p.x * p.y, 0.1 * std::sin(p.x)};
}

struct Case {
    const char* name;
    core::CellMesh (*mesh)();
    Vec3 lo, hi; ///< seeds
    double step; ///< s
    double target_ns;
};

/// 168,960 bent hexahedra, graded outward from a wall.
core::CellMesh hexahedra() {
    core::CellMesh mesh = tests::block({44, 80, 48}, tests::round_cylinder, true);
    for (const core::BoundaryFace& each : core::boundary_faces(mesh))
        if (each.face == 0) // the cylinder's
            mesh.cells[each.cell].beyond[0] = core::beyond_wall;
    return mesh;
}

/// As a mesher refines round a body, 2:1: 128,136 hexahedra, 17,864 pyramids, 56,000 tetrahedra.
core::CellMesh polyhedra() {
    using Kind = tests::TwoToOne::Kind;
    const auto kind = [](const Vec3& c) {
        const double away = glm::length((c - 0.5) * Vec3(1.0, 1.0, 0.3));
        return away < 0.03 ? Kind::Hole : away < 0.3 ? Kind::Fine : Kind::Coarse;
    };
    return tests::TwoToOne(36, kind, [](const Vec3& u) { return 16.0 * (tests::wavy(u) - 0.5); })
        .take();
}

constexpr Case cases[] = {
    {"hexahedra", hexahedra, {-5, -2, 1}, {-3, 2, 5}, 0.02, 100.0},
    {"polyhedra", polyhedra, {-6, -2, -2}, {-4, 2, 2}, 0.02, 200.0},
};

std::vector<Vec3> random_points(int count, const Vec3& lo, const Vec3& hi) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double x = part(random), y = part(random), z = part(random);
        points.push_back(lo + (hi - lo) * Vec3(x, y, z));
    }
    return points;
}

/// `velocity(p, v)` is false outside, where the particle ends. Returns how often it was asked.
template <class Velocity>
std::size_t advect(Vec3& p, double h, const Velocity& velocity) {
    std::size_t asked = 0;
    for (int i = 0; i < steps; ++i) {
        Vec3 k1, k2, k3, k4;
        asked += 4;
        if (!velocity(p, k1) || !velocity(p + 0.5 * h * k1, k2) ||
            !velocity(p + 0.5 * h * k2, k3) || !velocity(p + h * k3, k4))
            break;
        p += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return asked;
}

struct Ended {
    std::vector<Vec3> position;
    std::size_t asked = 0;
};

Ended advect_ours(const core::CellSampler& field, const std::vector<Vec3>& seeds, double h) {
    Ended ended;
    for (Vec3 p : seeds) {
        const auto cursor = field.cursor();
        ended.asked += advect(p, h, [&](const Vec3& at, Vec3& v) {
            v = cursor.velocity(at, 0.0);
            return cursor.status(at) == core::PointStatus::Inside;
        });
        ended.position.push_back(p);
    }
    return ended;
}

Ended advect_vtk(VtkCellField& field, const std::vector<Vec3>& seeds, double h) {
    Ended ended;
    for (Vec3 p : seeds) {
        ended.asked += advect(p, h, [&](const Vec3& at, Vec3& v) { return field.velocity(at, v); });
        ended.position.push_back(p);
    }
    return ended;
}

void measure(benchmark::State& state, const Case& which) {
    const core::CellMesh mesh = which.mesh();
    const std::vector<float> velocity = tests::at_nodes(mesh, round_it);
    std::unique_ptr<core::CellDomain> domain;
    const double build = on_one_core(
        [&] { return seconds_of([&] { domain = std::make_unique<core::CellDomain>(mesh); }); });
    const core::CellSampler field{domain.get(), velocity.data(), nullptr};
    VtkCellField peer(mesh, velocity);

    const std::vector<Vec3> seeds = random_points(particles, which.lo, which.hi);
    const core::Box& box = domain->locator.bounds();
    const std::vector<Vec3> anywhere = random_points(50'000, box.lo, box.hi);
    Ended ours, theirs;
    std::size_t found = 0, found_by_peer = 0;
    const std::vector<Turn> contenders{
        [&] { return seconds_of([&] { ours = advect_ours(field, seeds, which.step); }); },
        [&] { return seconds_of([&] { theirs = advect_vtk(peer, seeds, which.step); }); },
        [&] {
            found = 0;
            core::CellGeometry geometry;
            return seconds_of([&] {
                for (const Vec3& p : anywhere)
                    found += domain->locator.find(p, geometry).has_value();
            });
        },
        [&] {
            found_by_peer = 0;
            return seconds_of([&] {
                for (const Vec3& p : anywhere)
                    found_by_peer += peer.find(p);
            });
        },
    };
    for (auto _ : state) {
        const std::vector<Timed> taken = interleave(contenders, repetitions);
        state.SetIterationTime(taken[0].median);
        const double ns = 1e9 * taken[0].median / static_cast<double>(ours.asked);
        const double vtk_ns = 1e9 * taken[1].median / static_cast<double>(theirs.asked);
        double farthest = 0.0;
        for (std::size_t i = 0; i < seeds.size(); ++i)
            farthest = std::max(farthest, glm::length(ours.position[i] - theirs.position[i]));
        state.counters["cells"] = static_cast<double>(mesh.cells.size());
        state.counters["ns_per_evaluation"] = ns;
        state.counters["target_ns"] = which.target_ns;
        state.counters["vtk_ns_per_evaluation"] = vtk_ns;
        state.counters["times_faster_than_vtk"] = vtk_ns / ns;
        state.counters["vtk_in_last_cell"] =
            static_cast<double>(peer.in_last_cell) / static_cast<double>(peer.asked);
        state.counters["farthest_from_vtk"] = farthest;
        const auto lookups = static_cast<double>(anywhere.size());
        state.counters["random_ns"] = 1e9 * taken[2].median / lookups;
        state.counters["vtk_random_ns"] = 1e9 * taken[3].median / lookups;
        state.counters["found_more_than_vtk"] =
            static_cast<double>(found) - static_cast<double>(found_by_peer);
        state.counters["build_ms"] = 1e3 * build;
        state.counters["vtk_build_ms"] = 1e3 * peer.build_seconds();
        state.counters["bytes_per_cell"] =
            static_cast<double>(domain->locator.bytes()) / static_cast<double>(mesh.cells.size());
    }
}

/// A streak surface on its way round the body.
void measure_moving_surface(benchmark::State& state, const Case& which) {
    core::CellMesh mesh = which.mesh();
    for (const core::BoundaryFace& each : core::boundary_faces(mesh)) {
        const core::MeshCell& cell = mesh.cells[each.cell];
        const core::Vec3& corner =
            mesh.points[cell.node[core::face(cell.shape, each.face).node[0]]];
        if (corner.x * corner.x + corner.y * corner.y < 1.0)
            mesh.cells[each.cell].beyond[each.face] = core::beyond_wall;
    }
    const auto flow = tests::meshed_flow(std::move(mesh), {0.0, 2.0, 4.0, 6.0, 8.0, 10.0},
                                         [](const Vec3& p, double) { return round_it(p); });
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Streak;
    p.to = 10.0;
    p.separation = 0.12;
    const core::Rake rake{core::Rake::Kind::Line, {{-4.0, -0.9, 1.5}, {-4.0, 0.9, 2.5}}, 16};
    const core::SteadyClock clock;
    on_one_core([&] {
        for (auto _ : state) {
            std::vector<double> seconds;
            core::SurfaceStatistics made;
            for (int i = 0; i < 3; ++i) {
                auto surface = core::MovingSurface::start(
                    core::plan_surface(*flow, rake, p).value(), {}, clock);
                if (!surface)
                    throw std::runtime_error(surface.error().message);
                seconds.push_back(seconds_of([&] {
                    if (const auto done = surface->advance_to(p.to, {}); !done)
                        throw std::runtime_error(done.error().message);
                }));
                made = surface->statistics();
                state.counters["vertices"] =
                    static_cast<double>(surface->state().mesh.vertices.used());
            }
            const Timed taken = summarize(std::move(seconds));
            state.SetIterationTime(taken.median);
            state.counters["ns_per_vertex_step"] =
                1e9 * taken.median / static_cast<double>(made.vertex_steps);
            state.counters["target_ns"] = target_vertex_step_ns;
            state.counters["advect_share"] =
                made.seconds.advect / (made.seconds.advect + made.seconds.refine);
            state.counters["spread"] = taken.spread;
        }
    });
}

} // namespace cells_bench

void register_cells_benchmarks() {
    using namespace cells_bench;
    for (const Case& each : cases)
        benchmark::RegisterBenchmark((std::string("cells/") + each.name).c_str(),
                                     [each](benchmark::State& state) { measure(state, each); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    for (const Case& each : cases)
        benchmark::RegisterBenchmark(
            (std::string("cells/moving_surface/") + each.name).c_str(),
            [each](benchmark::State& state) { measure_moving_surface(state, each); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
}

} // namespace wakesurf::bench
