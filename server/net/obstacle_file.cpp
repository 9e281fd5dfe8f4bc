#include "server/net/obstacle_file.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/obstacle_surface.hpp"
#include "core/surface/wall_velocity.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/mesh_encoder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

/// Returns the surface at which particles stop, for display: that of the solid nodes, or the walls of the
/// store or of a built-in flow.
core::Result<core::QuadComplex> obstacle_of(const LoadedDataset& dataset) {
    const auto none = fail(Error::Code::NotFound, "the dataset has no obstacle",
                           "`dataset.describe` says whether it has one");
    const store::StoreReader* store = dataset.store.get();
    if (store != nullptr && !store->mask().empty())
        return core::obstacle_surface(store->grid(), store->mask());
    const auto walls = store != nullptr ? store->load_walls() : dataset.flow->walls();
    if (!walls)
        return tl::unexpected(walls.error());
    if (walls->triangles.empty())
        return none;
    return core::wall_surface(*walls);
}

/// The memory for the mesh, its frames and intermediate data, in bytes a vertex.
constexpr std::size_t obstacle_bytes = 400;
/// The additional memory for velocity, speed, s and t, as numbers and as codes, in bytes a vertex.
constexpr std::size_t flow_bytes = core::wall_velocity_bytes + 100;

} // namespace

core::Result<double> time_in_data(const LoadedDataset& dataset, double time) {
    if (dataset.info.steady)
        return dataset.info.times.empty() ? time : dataset.info.times.front();
    const auto range = dataset.flow->time_range();
    if (!range)
        return time;
    const auto [first, last] = *range;
    if (!core::within_rounding(time, first, last))
        return fail(Error::Code::OutOfTime,
                    fmt::format("time {} is outside the data's {} to {}", time, first, last),
                    "choose `time` inside it");
    return std::clamp(time, first, last);
}

core::Result<std::string> obstacle_frames(const LoadedDataset& dataset,
                                          std::optional<double> time,
                                          const core::MemoryAccount& account,
                                          core::MemoryAccount::Share& share,
                                          const std::stop_token& stop) {
    auto mesh = obstacle_of(dataset);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const std::size_t needed = mesh->vertices() * (obstacle_bytes + (time ? flow_bytes : 0));
    if (!share.grow_to(needed))
        return tl::unexpected(account.refusal("the file of this obstacle", needed));
    protocol::EncodeOptions options;
    options.final = true;
    options.attributes = time.has_value();
    protocol::MeshFields fields;
    if (time) {
        options.time = *time;
        if (auto added = core::add_wall_velocity(*mesh, *dataset.flow, *time, stop); !added)
            return tl::unexpected(added.error());
        for (const std::string_view name : core::velocity_component_names)
            fields.push_back(*core::vertex_component(*mesh, name));
    }
    const auto state = protocol::encode_state(
        *mesh, protocol::lattice_over(dataset.info.bounds, dataset.info.periodic), options, fields);
    if (!state)
        return tl::unexpected(state.error());
    std::string out;
    for (const auto& frame : state->frames) {
        protocol::Bytes length;
        protocol::append(length, static_cast<std::uint32_t>(frame->size()));
        out.append(reinterpret_cast<const char*>(length.data()), length.size());
        out.append(reinterpret_cast<const char*>(frame->data()), frame->size());
    }
    return out;
}

} // namespace wakesurf::server
