// Arrays of one's own, as a solver has them in memory: time-steps on a grid, without files. A vortex that spins up, and its streak surface.
#include <wakesurf/core/dataset/steps_in_memory.hpp>
#include <wakesurf/core/field/stored_flow.hpp>
#include <wakesurf/core/surface/builder/surface_builder.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

namespace ws = wakesurf::core;

// Of the whole vortex at a time; its integral is the angle that particles have turned by.
double angular_velocity(double t) {
    return 1.0 + t;
}

double angle_up_to(double t) {
    return t + 0.5 * t * t;
}

// Velocity at the nodes, x fastest: any function would do. This one is linear, and so exact between the nodes.
std::vector<float> velocity_at(const ws::UniformGrid& grid, double t) {
    std::vector<float> values;
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        const ws::Vec3 p = node_position(grid, node);
        for (const double each : {-angular_velocity(t) * p.y, angular_velocity(t) * p.x, 0.3})
            values.push_back(static_cast<float>(each));
    }
    return values;
}

int main() {
    const ws::UniformGrid grid{{-2, -2, 0}, ws::Vec3(0.125), {33, 33, 9}};
    const std::vector<double> times{0.0, 0.5, 1.0, 1.5, 2.0};
    std::vector<std::vector<float>> arrays;
    for (const double t : times)
        arrays.push_back(velocity_at(grid, t));
    const auto steps = ws::StepsInMemory::make(grid, times, {arrays.begin(), arrays.end()});
    if (!steps) {
        std::fprintf(stderr, "%s\n", steps.error().message.c_str());
        return 1;
    }
    // Steps that are made when they are asked for are a class of one's own, derived from TimeStepSource; the cache keeps what fits its budget.
    const auto cache = std::make_shared<ws::TimeStepCache>(*steps, ws::TimeStepCache::Options{});
    const auto flow = ws::make_stored_flow(cache);

    const ws::Rake rake{ws::Rake::Kind::Line, {{0.5, 0, 0.1}, {1.5, 0, 0.1}}, 17};
    ws::SurfaceParameters asked;
    asked.kind = ws::SurfaceKind::Streak;
    asked.from = 0.0;
    asked.to = 2.0;
    asked.separation = 0.05;
    const auto surface = ws::build_surface(*flow, rake, asked);
    if (!surface) {
        std::fprintf(stderr, "%s; %s\n", surface.error().message.c_str(),
                     surface.error().hint.c_str());
        return 1;
    }
    const ws::QuadComplex& mesh = surface->mesh;
    double worst = 0.0;
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        const double radius = 0.5 + mesh.s[v];
        const double angle =
            angle_up_to(asked.to) - angle_up_to(mesh.t[v]); // t: when it was released
        const ws::Vec3 expected(radius * std::cos(angle), radius * std::sin(angle),
                                0.1 + 0.3 * (asked.to - mesh.t[v]));
        worst = std::fmax(worst, glm::distance(mesh.position[v], expected));
    }
    std::printf("streak: %zu cells, off by %.1e\n", mesh.cells.size(), worst);
}
