#include "server/data/obstacle_mesh.hpp"

#include "core/surface/obstacle_surface.hpp"
#include "core/surface/wall_caps.hpp"
#include "server/data/surface_scalars.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace wakesurf::server {

using core::BoundaryPatch;
using core::Error;
using core::Result;
using core::WallGeometry;

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

namespace {

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

Result<core::QuadComplex> flow_beside(const LoadedDataset& dataset,
                                      const Obstacle& obstacle,
                                      double time,
                                      const std::stop_token& stop) {
    const bool masked = dataset.store != nullptr && !dataset.store->mask().empty();
    auto places = core::places_off_wall(obstacle.mesh, *dataset.flow,
                                        masked ? core::mask_distances : core::wall_distances, stop);
    if (!places)
        return tl::unexpected(places.error());
    const std::size_t count = places->size();
    std::vector<core::Vec3> sampled_at = *places;
    std::vector<std::uint8_t> nothing(count, 0);
    for (std::size_t i = 0; i < count; ++i)
        if (i >= obstacle.walls || std::isnan(sampled_at[i].x)) {
            nothing[i] = 1;
            sampled_at[i] = obstacle.mesh.position[i];
        }
    const std::vector<double> times(count, time);
    std::vector<core::Vec3> velocity(count);
    if (auto sampled = dataset.flow->sample(sampled_at, times, velocity, stop); !sampled)
        return tl::unexpected(sampled.error());
    if (auto marked = dataset.flow->mark_gaps(sampled_at, times, nothing, stop); !marked)
        return tl::unexpected(marked.error());
    core::QuadComplex beside;
    beside.position = *std::move(places);
    for (std::size_t i = 0; i < count; ++i)
        beside.velocity.push_back(nothing[i] == 0
                                      ? core::Vec3f(velocity[i])
                                      : core::Vec3f(std::numeric_limits<float>::quiet_NaN()));
    return beside;
}

Result<std::vector<float>> values_beside(const LoadedDataset& dataset,
                                         const Obstacle& obstacle,
                                         double time,
                                         const std::string& field,
                                         const std::stop_token& stop) {
    const auto sampled = flow_beside(dataset, obstacle, time, stop);
    if (!sampled)
        return tl::unexpected(sampled.error());
    const core::QuadComplex& beside = *sampled;
    const std::vector<double> times(beside.position.size(), time);
    auto scalars = surface_scalars(dataset, beside, times, {field}, stop);
    if (!scalars)
        return tl::unexpected(scalars.error());
    std::vector<float> values;
    if (const auto found = scalars->find(field); found != scalars->end())
        values = std::move(found->second);
    else if (field == dataset.info.velocity) // its magnitude
        for (core::VertexId v = 0; v < beside.vertices(); ++v)
            values.push_back(static_cast<float>(beside.speed(v)));
    else
        return core::fail(Error::Code::NotFound,
                          "`" + field + "` is a field of surfaces, not of obstacles",
                          "choose a stored field, the velocity, vorticity or q_criterion");
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i >= obstacle.walls || std::isnan(beside.position[i].x))
            values[i] = std::numeric_limits<float>::quiet_NaN();
    return values;
}

} // namespace wakesurf::server
