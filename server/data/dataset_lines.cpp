#include "server/data/dataset_lines.hpp"

#include "core/base/rounding.hpp"
#include "core/field/time_in_data.hpp"
#include "core/surface/lines/wall_lines.hpp"
#include "core/surface/obstacle_surface.hpp"
#include "server/data/obstacle_mesh.hpp"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <limits>
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

/// The walls of the bodies, or patches by their names, without what closes bodies at the sides of the domain.
core::Result<Obstacle> walls_of(const core::LineSeeds& seeds, const LoadedDataset& dataset) {
    const bool named = !seeds.patches.empty();
    auto obstacle = obstacle_of(
        dataset, {named ? PatchChoice::Of::Named : PatchChoice::Of::Body, seeds.patches});
    if (obstacle)
        std::erase_if(obstacle->mesh.cells, [&](const core::Cell& cell) {
            return std::any_of(cell.corner.begin(), cell.corner.end(),
                               [&](core::VertexId corner) { return corner >= obstacle->walls; }) ||
                   (!named && closes_at_side(obstacle->mesh, cell, *dataset.flow));
        });
    return obstacle;
}

/// Returns places in the fluid off walls.
core::Result<std::vector<core::Vec3>> places_off(const core::QuadComplex& walls,
                                                 const core::LineSeeds& seeds,
                                                 const LoadedDataset& dataset,
                                                 const std::stop_token& stop) {
    const auto on_wall = core::even_wall_places(walls, seeds.seeds, stop);
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

/// Returns a field beside walls, not a number where there is none.
core::Result<std::vector<float>> field_beside(const std::vector<core::Vec3>& places,
                                              const core::SampledField& field,
                                              const core::Flow& flow,
                                              double time,
                                              const std::stop_token& stop) {
    std::vector<core::Vec3> known;
    for (const core::Vec3& each : places)
        if (core::finite(each))
            known.push_back(each);
    const auto values = core::sample_field(field, flow, known, time, stop);
    if (!values)
        return tl::unexpected(values.error());
    std::vector<float> out;
    std::size_t next = 0;
    for (const core::Vec3& each : places)
        out.push_back(core::finite(each) ? (*values)[next++]
                                         : std::numeric_limits<float>::quiet_NaN());
    return out;
}

/// Returns how large walls are: a body may be small in its domain.
double diagonal_of(const core::QuadComplex& walls) {
    core::Box box{core::Vec3(0.0), core::Vec3(0.0)};
    for (bool first = true; const core::Cell& cell : walls.cells)
        for (const core::VertexId corner : cell.corner) {
            const core::Vec3& at = walls.position[corner];
            box = first ? core::Box{at, at} : core::Box{glm::min(box.lo, at), glm::max(box.hi, at)};
            first = false;
        }
    return box.diagonal();
}

core::Result<core::StreamLines> lines_along(const Obstacle& walls,
                                            const core::LineSeeds& seeds,
                                            core::StreamLinesRequest request,
                                            const LoadedDataset& dataset,
                                            core::WorkMemory& memory,
                                            const std::stop_token& stop) {
    const core::Flow& flow = *dataset.flow;
    const auto time = core::time_in_data(flow, request.time);
    if (!time)
        return tl::unexpected(time.error());
    const auto beside = flow_beside(dataset, walls, *time, stop);
    if (!beside)
        return tl::unexpected(beside.error());
    const auto values = field_beside(beside->position, request.field, flow, *time, stop);
    if (!values)
        return tl::unexpected(values.error());
    const auto places = core::even_wall_places(walls.mesh, seeds.seeds, stop);
    if (!places)
        return tl::unexpected(places.error());
    if (!(request.length > 0.0))
        request.length = core::lengths_in_domain * flow.domain().diagonal();
    return core::trace_wall_lines(request, {walls.mesh, beside->velocity, *values}, *places,
                                  diagonal_of(walls.mesh) / core::gaps_in_domain, memory, stop);
}

/// Traces lines off walls or along them.
core::Result<core::StreamLines> lines_at_walls(const core::LineSeeds& seeds,
                                               const core::StreamLinesRequest& request,
                                               const LoadedDataset& dataset,
                                               core::WorkMemory& memory,
                                               const std::stop_token& stop) {
    auto walls = walls_of(seeds, dataset);
    if (!walls)
        return tl::unexpected(walls.error());
    const bool along = seeds.kind == core::LineSeeds::Kind::Along;
    const std::size_t bytes =
        walls->mesh.vertices() * (wall_bytes + (along ? core::wall_velocity_bytes : 0));
    if (!memory.grow(bytes))
        return tl::unexpected(memory.refusal());
    if (along) {
        auto lines = lines_along(*walls, seeds, request, dataset, memory, stop);
        memory.shrink(bytes);
        return lines;
    }
    const auto places = places_off(walls->mesh, seeds, dataset, stop);
    *walls = {};
    memory.shrink(bytes);
    if (!places)
        return tl::unexpected(places.error());
    return core::trace_stream_lines(request, *dataset.flow, *places, memory, stop);
}

} // namespace

core::Result<core::StreamLines> dataset_lines(const core::LineSeeds& seeds,
                                              const core::StreamLinesRequest& request,
                                              const LoadedDataset& dataset,
                                              core::WorkMemory& memory,
                                              const std::stop_token& stop) {
    if (auto sound = core::check_line_seeds(seeds, dataset.flow->domain()); !sound)
        return tl::unexpected(sound.error());
    return (core::of_walls(seeds.kind)
                ? lines_at_walls(seeds, request, dataset, memory, stop)
                : core::trace_stream_lines(request, *dataset.flow, core::line_seed_places(seeds),
                                           memory, stop))
        .map_error([](core::Error error) {
            if (error.code == core::Error::Code::OverLimit)
                error.hint =
                    "ask for fewer seeds or shorter lines, or give the process more --memory";
            return error;
        });
}

} // namespace wakesurf::server
