#include "server/data/dataset_lines.hpp"

#include "core/base/rounding.hpp"
#include "server/data/obstacle_mesh.hpp"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <vector>

namespace wakesurf::server {

namespace {

/// Of a wall's vertex, with its cells and what it is made from, in bytes.
constexpr std::size_t wall_bytes = 120;

/// Returns whether a cell lies in a side of the domain with no fluid at it: it closes the solid nodes of a body that goes on beyond. The floor
/// of a channel has fluid at it.
bool closes_at_side(const core::QuadComplex& mesh, const core::Cell& cell, const core::Flow& flow) {
    const auto at = [&](std::size_t i) { return mesh.position[cell.corner[i]]; };
    const core::Vec3 middle = 0.25 * (at(0) + at(1) + at(2) + at(3));
    const core::Box box = flow.domain();
    const core::Vec3 slack = core::rounding(box);
    if (glm::all(glm::greaterThan(middle, box.lo + slack)) &&
        glm::all(glm::lessThan(middle, box.hi - slack)))
        return false;
    const core::Vec3 across = glm::cross(at(2) - at(0), at(3) - at(1));
    const double length = glm::length(across);
    if (!(length > 0.0))
        return true;
    for (const double distance : {-1.0, -0.5, 0.5, 1.0})
        if (flow.status(middle + distance * flow.finest_spacing() / length * across) ==
            core::PointStatus::Inside)
            return false;
    return true;
}

/// Returns places in the fluid off the walls; what closes bodies at the sides of the domain is none of them.
core::Result<std::vector<core::Vec3>> places_off_walls(const core::LineSeeds& seeds,
                                                       const LoadedDataset& dataset,
                                                       core::WorkMemory& memory,
                                                       const std::stop_token& stop) {
    auto obstacle = obstacle_of(dataset);
    if (!obstacle)
        return tl::unexpected(obstacle.error());
    core::QuadComplex& mesh = obstacle->mesh;
    const std::size_t bytes = mesh.vertices() * wall_bytes;
    if (!memory.grow(bytes))
        return tl::unexpected(memory.refusal());
    std::erase_if(mesh.cells, [&](const core::Cell& cell) {
        return std::any_of(cell.corner.begin(), cell.corner.end(),
                           [&](core::VertexId corner) { return corner >= obstacle->walls; }) ||
               closes_at_side(mesh, cell, *dataset.flow);
    });
    const auto on_wall = core::even_wall_places(mesh, seeds.seeds, stop);
    memory.shrink(bytes);
    if (!on_wall)
        return tl::unexpected(on_wall.error());
    std::vector<core::Vec3> out;
    for (const core::WallPlace& each : *on_wall) {
        const core::Vec3 off = seeds.distance * each.normal;
        const auto inside = [&](const core::Vec3& place) {
            return dataset.flow->status(place) == core::PointStatus::Inside;
        };
        // Walls of stores are turned as their source has them.
        out.push_back(!inside(each.place + off) && inside(each.place - off) ? each.place - off
                                                                            : each.place + off);
    }
    return out;
}

} // namespace

core::Result<core::StreamLines> dataset_lines(const core::LineSeeds& seeds,
                                              const core::StreamLinesRequest& request,
                                              const LoadedDataset& dataset,
                                              core::WorkMemory& memory,
                                              const std::stop_token& stop) {
    if (auto sound = core::check_line_seeds(seeds, dataset.flow->domain()); !sound)
        return tl::unexpected(sound.error());
    const auto places = seeds.kind == core::LineSeeds::Kind::Walls
                            ? places_off_walls(seeds, dataset, memory, stop)
                            : core::Result<std::vector<core::Vec3>>(core::line_seed_places(seeds));
    if (!places)
        return tl::unexpected(places.error());
    return core::trace_stream_lines(request, *dataset.flow, *places, memory, stop)
        .map_error([](core::Error error) {
            if (error.code == core::Error::Code::OverLimit)
                error.hint =
                    "ask for fewer seeds or shorter lines, or give the process more --memory";
            return error;
        });
}

} // namespace wakesurf::server
