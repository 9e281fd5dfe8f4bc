#include "server/data/obstacle_mesh.hpp"

#include "core/surface/obstacle_surface.hpp"
#include "core/surface/wall_caps.hpp"

#include <utility>

namespace wakesurf::server {

core::Result<Obstacle> obstacle_of(const LoadedDataset& dataset) {
    const auto none = core::fail(core::Error::Code::NotFound, "the dataset has no obstacle",
                                 "`dataset.describe` says whether it has one");
    const store::StoreReader* store = dataset.store.get();
    if (store != nullptr && !store->mask().empty()) {
        auto mesh = core::obstacle_surface(store->grid(), store->mask());
        const std::size_t all = mesh.vertices();
        return Obstacle{std::move(mesh), all};
    }
    auto walls = store != nullptr ? store->load_walls() : dataset.flow->walls();
    if (!walls)
        return tl::unexpected(walls.error());
    if (walls->triangles.empty())
        return none;
    const std::size_t count = walls->points.size();
    core::close_at_sides(*walls, *dataset.flow);
    return Obstacle{core::wall_surface(*walls), count};
}

} // namespace wakesurf::server
