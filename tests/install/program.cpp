// A stream surface round a vortex, whose particles go in circles: a program that knows only the installed headers.
#include "core/field/analytic_flow.hpp"
#include "core/surface/contour_lines.hpp"
#include "core/surface/surface_builder.hpp"

#include <cmath>
#include <cstdio>

namespace ws = wakesurf::core;

int main() {
    const auto flow = ws::make_analytic_flow("lamb-oseen?rc=0.2");
    if (!flow) {
        std::fprintf(stderr, "%s\n", flow.error().message.c_str());
        return 1;
    }
    const ws::Rake rake{ws::Rake::Kind::Line, {{0.1, 0, 0}, {1.5, 0, 0}}, 32};
    ws::SurfaceParameters parameters;
    parameters.to = 3.0;
    parameters.separation = 0.05;
    const auto surface = ws::build_surface(**flow, rake, parameters);
    if (!surface) {
        std::fprintf(stderr, "%s\n", surface.error().message.c_str());
        return 1;
    }
    const ws::QuadComplex& mesh = surface->mesh;
    double worst = 0.0; // of the distance from the axis, which no particle changes
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        const ws::Vec3& at = mesh.position[v];
        worst = std::fmax(worst, std::fabs(std::hypot(at.x, at.y) - (0.1 + 1.4 * mesh.s[v])));
    }
    const auto lines = ws::contour_lines(mesh, mesh.t, ws::evenly_spaced(mesh.t, 4));
    std::printf("%zu cells, %zu timelines, off by %.1e\n", mesh.cells.size(), lines.size(), worst);
    return mesh.validate().empty() ? 0 : 1;
}
