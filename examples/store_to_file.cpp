// A store, as `wakesurf import` and `wakesurf generate` write them, to a surface in a file.
//   store_to_file STORE "x,y,z x,y,z" FILE.vtp      .ply, .glb, .obj and .drc as well
#include <wakesurf/core/field/stored_flow.hpp>
#include <wakesurf/core/surface/builder/surface_builder.hpp>
#include <wakesurf/protocol/files/mesh_file.hpp>
#include <wakesurf/store/open_store.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

namespace ws = wakesurf;

int failed(const ws::core::Error& error) {
    std::fprintf(stderr, "%s; %s\n", error.message.c_str(), error.hint.c_str());
    return 1;
}

int main(int count, char** arguments) {
    ws::core::Vec3 a, b;
    if (count != 4 || std::sscanf(arguments[2], "%lf,%lf,%lf %lf,%lf,%lf", &a.x, &a.y, &a.z, &b.x,
                                  &b.y, &b.z) != 6) {
        std::fprintf(stderr, "store_to_file STORE \"x,y,z x,y,z\" FILE\n");
        return 2;
    }
    const std::filesystem::path file = arguments[3];
    const auto format = ws::protocol::mesh_format(file.extension().string().erase(0, 1));
    if (!format) {
        std::fprintf(stderr, "surfaces are written as %s\n",
                     ws::protocol::mesh_extensions().c_str());
        return 2;
    }

    const auto store = ws::store::open_store(arguments[1]);
    if (!store)
        return failed(store.error());
    ws::core::TimeStepCache::Options memory;
    memory.budget_bytes = std::size_t{1} << 30; // larger series are read piece by piece
    const auto flow = ws::core::make_stored_flow(
        std::make_shared<ws::core::TimeStepCache>(store->reader, memory));

    ws::core::SurfaceParameters asked;
    asked.kind = ws::core::SurfaceKind::Streak;
    asked.from = store->info.times.front();
    asked.to = store->info.times.back();
    asked.separation = store->info.finest_spacing;
    const ws::core::Rake rake{ws::core::Rake::Kind::Line, {a, b}, 32};
    const auto surface = ws::core::build_surface(*flow, rake, asked);
    if (!surface)
        return failed(surface.error());

    ws::protocol::MeshMetadata about;
    about.rake = rake;
    about.parameters = asked;
    about.separation =
        surface->statistics.separation; // larger than asked where the quad budget did not do
    about.dataset = store->info.dataset;
    const auto bytes = ws::protocol::mesh_file(*format, surface->mesh, about, {});
    if (!bytes)
        return failed(bytes.error());
    std::ofstream(file, std::ios::binary) << *bytes;
    std::printf("%s: %zu quads, %zu vertices\n", file.c_str(), surface->mesh.cells.size(),
                surface->mesh.vertices());
}
