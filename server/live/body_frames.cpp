#include "server/live/body_frames.hpp"

#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/obstacle_surface.hpp"
#include "protocol/wire/lattice.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "server/data/obstacle_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace wakesurf::server {

namespace {

/// The memory for the mesh, its frames and intermediate data, in bytes a vertex.
constexpr std::size_t obstacle_bytes = 400;
/// The additional memory for velocity, a field, speed, s and t, as numbers and as codes, in bytes a vertex.
constexpr std::size_t flow_bytes = core::wall_velocity_bytes + 150;

} // namespace

core::Result<std::string> body_frames(const LoadedDataset& dataset,
                                      std::optional<double> time,
                                      const std::string& field,
                                      const PatchChoice& patches,
                                      const core::MemoryAccount& account,
                                      core::MemoryAccount::Share& share,
                                      const std::stop_token& stop) {
    auto obstacle = obstacle_of(dataset, patches);
    if (!obstacle)
        return tl::unexpected(obstacle.error());
    core::QuadComplex& mesh = obstacle->mesh;
    const std::size_t needed = mesh.vertices() * (obstacle_bytes + (time ? flow_bytes : 0));
    if (!share.grow_to(needed))
        return tl::unexpected(account.refusal("the file of this obstacle", needed));
    protocol::EncodeOptions options;
    options.final = true;
    options.attributes = time.has_value();
    protocol::MeshFields fields;
    if (time) {
        options.time = *time;
        if (auto added = core::add_wall_velocity(mesh, *dataset.flow, *time, stop); !added)
            return tl::unexpected(added.error());
        std::fill(mesh.velocity.begin() + static_cast<std::ptrdiff_t>(obstacle->walls),
                  mesh.velocity.end(), core::Vec3f(0.0F));
        for (const std::string_view name : core::velocity_component_names)
            fields.push_back(*core::vertex_component(mesh, name));
        if (!field.empty()) {
            auto values = values_beside(dataset, *obstacle, *time, field, stop);
            if (!values)
                return tl::unexpected(values.error());
            fields.push_back(*std::move(values));
        }
    }
    return protocol::encode_state(
               mesh, protocol::lattice_over(dataset.info.bounds, dataset.info.periodic), options,
               fields)
        .map([](const protocol::EncodedState& state) {
            std::string out;
            protocol::append_with_lengths(out, state.frames);
            return out;
        });
}

core::Result<AnimatedBody> animated_body(const LoadedDataset& dataset,
                                         std::size_t most,
                                         const core::MemoryAccount& account,
                                         core::MemoryAccount::Share& share,
                                         const std::stop_token& stop) {
    auto frames = body_frames(dataset, {}, "", {}, account, share, stop);
    if (!frames && frames.error().code == core::Error::Code::NotFound)
        return AnimatedBody{};
    if (!frames)
        return tl::unexpected(frames.error());
    if (frames->size() <= most)
        return AnimatedBody{*std::move(frames), {}};
    const auto in_file = [](std::size_t bytes) { return static_cast<double>(bytes) / 0.75e6; };
    return AnimatedBody{{},
                        fmt::format("The body is not in this file: it would take {:.2g} MB of it, "
                                    "and at most {:.2g} are spent on one.",
                                    in_file(frames->size()), in_file(most))};
}

} // namespace wakesurf::server
