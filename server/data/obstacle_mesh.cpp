#include "server/data/obstacle_mesh.hpp"

#include "core/surface/obstacle_surface.hpp"
#include "core/surface/wall_caps.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace wakesurf::server {

using core::BoundaryPatch;
using core::Error;
using core::Result;
using core::WallGeometry;

namespace {

core::Error no_patch(const std::string& name, const std::vector<BoundaryPatch>& patches) {
    constexpr std::size_t most = 20;
    std::vector<std::string> known;
    for (const BoundaryPatch& patch : patches)
        if (std::ranges::find(known, patch.name) == known.end())
            known.push_back(patch.name);
    std::string list;
    for (std::size_t i = 0; i < std::min(most, known.size()); ++i)
        list += (i == 0 ? "" : ", ") + known[i];
    if (known.size() > most)
        list += ", ...";
    return {Error::Code::NotFound, "there is no patch " + name,
            known.empty() ? "the data name no patches of their boundary" : "they are " + list};
}

/// Returns the patches of the names alone.
Result<WallGeometry> named(const WallGeometry& walls, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (std::ranges::find(walls.patches, name, &BoundaryPatch::name) == walls.patches.end())
            return tl::unexpected(no_patch(name, walls.patches));
    WallGeometry out;
    constexpr auto none = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> number(walls.points.size(), none);
    std::size_t first = 0;
    for (const BoundaryPatch& patch : walls.patches) {
        const std::size_t end = first + patch.triangles;
        const bool wanted = std::ranges::find(names, patch.name) != names.end();
        for (; wanted && first < end; ++first) {
            auto triangle = walls.triangles[first];
            for (std::uint32_t& point : triangle) {
                if (number[point] == none) {
                    number[point] = static_cast<std::uint32_t>(out.points.size());
                    out.points.push_back(walls.points[point]);
                }
                point = number[point];
            }
            out.triangles.push_back(triangle);
        }
        if (wanted)
            out.patches.push_back(patch);
        first = end;
    }
    return out;
}

/// Appends what closes the body.
void close_body(WallGeometry& walls, const core::Flow& flow) {
    WallGeometry body = core::body_of(walls);
    const std::size_t triangles = body.triangles.size();
    const std::size_t points = body.points.size();
    core::close_at_sides(body, flow);
    const auto shift = static_cast<std::uint32_t>(walls.points.size() - points);
    walls.points.insert(walls.points.end(),
                        body.points.begin() + static_cast<std::ptrdiff_t>(points),
                        body.points.end());
    for (std::size_t i = triangles; i < body.triangles.size(); ++i) {
        const auto [a, b, c] = body.triangles[i];
        walls.triangles.push_back({a + shift, b + shift, c + shift});
    }
}

} // namespace

Result<Obstacle> obstacle_of(const LoadedDataset& dataset, const PatchChoice& choice) {
    using Of = PatchChoice::Of;
    const store::StoreReader* store = dataset.store.get();
    if (store != nullptr && !store->mask().empty()) {
        if (choice.of == Of::Named)
            return tl::unexpected(no_patch(choice.names.front(), {}));
        auto mesh = core::obstacle_surface(store->grid(), store->mask());
        const std::size_t all = mesh.vertices();
        return Obstacle{std::move(mesh), all};
    }
    auto walls = store != nullptr ? store->load_walls() : dataset.flow->walls();
    if (walls && choice.of == Of::Named)
        walls = named(*walls, choice.names);
    if (walls && choice.of == Of::Body)
        walls = core::body_of(*std::move(walls));
    if (!walls)
        return tl::unexpected(walls.error());
    if (walls->triangles.empty())
        return core::fail(Error::Code::NotFound, "the dataset has no obstacle",
                          "`dataset.describe` says whether it has one");
    const std::size_t count = walls->points.size();
    if (choice.of != Of::Named)
        close_body(*walls, *dataset.flow);
    return Obstacle{core::wall_surface(*walls), count, walls->patches};
}

} // namespace wakesurf::server
