#include "server/live/animation_file.hpp"

#include "core/base/clock.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/time_direction.hpp"
#include "protocol/files/animation_page.hpp"
#include "server/base/sha256.hpp"
#include "server/data/datasets.hpp"
#include "server/live/animation_description.hpp"
#include "server/live/body_frames.hpp"
#include "server/live/surface_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace wakesurf::server {

using core::Error;

core::Result<core::SurfacePlan> until(core::SurfacePlan plan, double last) {
    core::SurfaceParameters p = plan.parameters;
    if (p.kind == core::SurfaceKind::Level || last == p.to || last == p.from)
        return plan;
    p.to = last;
    if (p.release_until && !core::between(*p.release_until, p.from, last))
        p.release_until.reset();
    return core::plan_surface(plan.flow, plan.rake, std::move(p));
}

core::Result<void> check_moves(const core::SurfacePlan& plan, const core::DatasetInfo& dataset) {
    const core::SurfaceParameters& p = plan.parameters;
    if (p.from == p.to)
        return core::fail(
            Error::Code::InvalidArgument,
            fmt::format("nothing moves: the surface is of one time, {}", core::time_text(p.from)),
            "choose another `to`");
    if (p.kind == core::SurfaceKind::Level && dataset.steady)
        return core::fail(
            Error::Code::InvalidArgument,
            "nothing moves: the level surface of a steady flow is the same at all times",
            "save a picture, or a mesh");
    return {};
}

namespace {

core::Result<SurfaceJob> animated_job(const protocol::Recipe& recipe,
                                      const core::SurfacePlan& plan,
                                      const LoadedDataset& dataset) {
    const OpenDataset open{
        dataset.info,  protocol::lattice_over(dataset.info.bounds, dataset.info.periodic),
        dataset.flow,  dataset.cache,
        dataset.store, dataset.scalars,
        dataset.levels};
    return fields_once(open, recipe.fields).map([&](const std::vector<std::string>& names) {
        return SurfaceJob{.number = 1,
                          .epoch = 1,
                          .plan = plan,
                          .store = dataset.store,
                          .scalars = dataset.scalars,
                          .fields = fields_there(open, names),
                          .lattice = open.lattice};
    });
}

std::string digest_of_frames(std::string_view frames, std::string_view body) {
    Sha256 sum;
    sum.add(fmt::format("{} {}", frames.size(), body.size()));
    sum.add(frames);
    sum.add(body);
    return digest_text(sum.digest());
}

} // namespace

core::Result<AnimationFile> make_animation_file(protocol::Recipe recipe,
                                                const core::SurfacePlan& plan,
                                                const LoadedDataset& dataset,
                                                std::string_view viewer,
                                                const std::stop_token& stop,
                                                const FileMemory& memory,
                                                const std::string& text,
                                                core::WorkDone* done) {
    if (recipe.times.empty() || recipe.times.size() > most_steps)
        return core::fail(Error::Code::InvalidArgument,
                          fmt::format("an animation has 1 to {} steps", most_steps));
    if (auto moving = check_moves(plan, dataset.info); !moving)
        return tl::unexpected(moving.error());
    core::WorkMemory work(*memory.account, stop, memory.patience, "an animation of this surface");
    const core::WorkPart part{done, &work};
    const auto job = animated_job(recipe, plan, dataset);
    if (!job)
        return tl::unexpected(job.error());
    auto animation = animate(*job, recipe.times, core::SteadyClock{}, stop, part);
    if (!animation)
        return tl::unexpected(animation.error());
    const core::SurfaceStatistics& statistics = animation->last.statistics;
    if (statistics.empty && !statistics.empty->natural())
        return core::fail(Error::Code::InvalidArgument, statistics.empty->message,
                          statistics.empty->hint);
    // Where they cannot be estimated, the file says so.
    const auto stated = core::state_interval_errors(plan, animation->last, stop, part);
    if (stop.stop_requested())
        return core::fail(Error::Code::Cancelled, "stopped, nothing was written");
    if (!stated)
        animation->last.statistics.interval_left_out = stated.error().message;
    auto body = animated_body(dataset, most_body_bytes, *memory.account, *memory.share, stop);
    if (!body)
        return tl::unexpected(body.error());
    auto description = description_of(*animation, *job, dataset.info, recipe.version);
    description.look = recipe.look;
    if (!body->without.empty())
        description.facts.push_back(body->without);
    recipe.mesh = digest_of_frames(animation->frames, body->frames);
    // In base64, and once more while it is sealed.
    const std::size_t needed =
        2 * viewer.size() + 4 * (animation->frames.size() + body->frames.size());
    if (!memory.share->grow_to(needed, stop, memory.patience))
        return tl::unexpected(memory.account->refusal("an animation of this surface", needed));
    const std::string own = text.empty() ? protocol::recipe_text(recipe) : text;
    auto page = protocol::animation_page(
        viewer, {std::move(description), animation->frames, body->frames, own});
    if (!page)
        return tl::unexpected(page.error());
    seal(*page);
    return AnimationFile{.file = {*std::move(page), recipe.mesh},
                         .statistics = statistics,
                         .without_body = body->without,
                         .frame_bytes = animation->frames.size(),
                         .most_vertices = animation->most_vertices,
                         .all_vertices = animation->all_vertices};
}

} // namespace wakesurf::server
