#include "server/data/obstacle_file.hpp"

#include "core/surface/obstacle_surface.hpp"
#include "protocol/files/wall_vtp.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

using core::Result;

namespace {

/// The memory for the mesh and the file, and for each field, in bytes a vertex.
constexpr std::size_t vertex_bytes = 400, field_bytes = core::wall_velocity_bytes + 100;

void leave_out_caps(Obstacle& obstacle) {
    core::QuadComplex& mesh = obstacle.mesh;
    std::erase_if(mesh.cells, [&](const core::Cell& cell) {
        return std::ranges::any_of(cell.corner,
                                   [&](core::VertexId corner) { return corner >= obstacle.walls; });
    });
    mesh.position.resize(obstacle.walls);
}

Result<protocol::WallValues> wall_values(const LoadedDataset& dataset,
                                         const Obstacle& obstacle,
                                         const std::string& field,
                                         double time,
                                         const std::stop_token& stop) {
    if (field == dataset.info.velocity) {
        return flow_beside(dataset, obstacle, time, stop).map([&](const core::QuadComplex& beside) {
            protocol::WallValues out{field, 3, {}};
            for (const core::Vec3f& v : beside.velocity)
                out.values.insert(out.values.end(), {v.x, v.y, v.z});
            return out;
        });
    }
    return values_beside(dataset, obstacle, time, field, stop).map([&](std::vector<float> values) {
        return protocol::WallValues{field, 1, std::move(values)};
    });
}

} // namespace

Result<ObstacleFile> obstacle_file(const LoadedDataset& dataset,
                                   const ObstacleFileRequest& request,
                                   const core::MemoryAccount& account,
                                   core::MemoryAccount::Share& share,
                                   const std::stop_token& stop) {
    auto obstacle = obstacle_of(dataset, request.patches);
    if (!obstacle)
        return tl::unexpected(obstacle.error());
    leave_out_caps(*obstacle);
    const std::size_t vertices = obstacle->mesh.vertices();
    const std::size_t needed = vertices * (vertex_bytes + request.fields.size() * field_bytes);
    if (!share.grow_to(needed))
        return tl::unexpected(account.refusal("the file of this body", needed));
    std::vector<protocol::WallValues> values;
    for (const std::string& field : request.fields) {
        auto beside = wall_values(dataset, *obstacle, field, request.time.value_or(0.0), stop);
        if (!beside)
            return tl::unexpected(beside.error());
        values.push_back(*std::move(beside));
    }
    return ObstacleFile{protocol::wall_vtp(obstacle->mesh, obstacle->patches, values, request.time),
                        vertices, obstacle->mesh.cells.size(), obstacle->patches};
}

} // namespace wakesurf::server
