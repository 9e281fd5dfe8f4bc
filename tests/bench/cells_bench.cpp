#include "core/dataset/cell_neighbours.hpp"
#include "core/surface/moving/moving_surface.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/meshed_source.hpp"

#include <benchmark/benchmark.h>

#include <stdexcept>

namespace wakesurf::bench {

namespace cells_bench {

using core::Vec3;

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
    {"hexahedra", hexahedra},
    {"polyhedra", polyhedra},
};

/// A streak surface on its way round the body.
void measure(benchmark::State& state, const Case& which) {
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
        benchmark::RegisterBenchmark((std::string("cells/moving_surface/") + each.name).c_str(),
                                     [each](benchmark::State& state) { measure(state, each); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
}

} // namespace wakesurf::bench
