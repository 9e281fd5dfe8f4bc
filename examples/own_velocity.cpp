// A velocity of one's own: a wind that sways. Its stream surface is flat at any time; its streak surface, the smoke, has waves.
//   own_velocity [FOLDER]     writes stream.vtp and streak.vtp
#include <wakesurf/core/field/function_flow.hpp>
#include <wakesurf/core/surface/builder/surface_builder.hpp>
#include <wakesurf/protocol/files/mesh_file.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

namespace ws = wakesurf::core;

ws::Vec3 wind(const ws::Vec3&, double t) {
    return {1.0, 0.5 * std::sin(2.0 * t), 0.0};
}

// Where the wind has carried the particle of a vertex, by integration with pencil and paper. `t` is the time since the release on a stream
// surface, and the time of the release on a streak surface.
ws::Vec3 carried(const ws::SurfaceParameters& asked, double t) {
    if (asked.kind == ws::SurfaceKind::Stream) // the wind stands still at the time `from`
        return wind({}, asked.from) * t;
    return {asked.to - t, 0.25 * (std::cos(2.0 * t) - std::cos(2.0 * asked.to)), 0.0};
}

int main(int count, char** arguments) {
    const std::string folder = count > 1 ? arguments[1] : ".";
    const auto flow = ws::make_function_flow(wind, {{0, -2, -2}, {8, 2, 2}});
    const ws::Rake rake{ws::Rake::Kind::Line, {{0.5, 0, -1}, {0.5, 0, 1}}, 9};
    for (const auto kind : {ws::SurfaceKind::Stream, ws::SurfaceKind::Streak}) {
        const std::string name = kind == ws::SurfaceKind::Stream ? "stream" : "streak";
        ws::SurfaceParameters asked;
        asked.kind = kind;
        asked.from = 1.0;
        asked.to = 5.0;
        asked.separation = 0.1;
        const auto surface = ws::build_surface(*flow, rake, asked);
        if (!surface) {
            std::fprintf(stderr, "%s; %s\n", surface.error().message.c_str(),
                         surface.error().hint.c_str());
            return 1;
        }
        const ws::QuadComplex& mesh = surface->mesh;
        double worst = 0.0;
        for (std::size_t v = 0; v < mesh.vertices(); ++v) {
            const ws::Vec3 seed(0.5, 0.0, 2.0 * mesh.s[v] - 1.0);
            worst =
                std::fmax(worst, glm::distance(mesh.position[v], seed + carried(asked, mesh.t[v])));
        }
        wakesurf::protocol::MeshMetadata about;
        about.rake = rake;
        about.parameters = asked;
        about.separation = surface->statistics.separation;
        const auto file = mesh_file(wakesurf::protocol::MeshFormat::Vtp, mesh, about, {});
        if (!file || !(std::ofstream(folder + "/" + name + ".vtp", std::ios::binary) << *file))
            return 1;
        std::printf("%s: %zu cells, off by %.1e\n", name.c_str(), mesh.cells.size(), worst);
    }
}
