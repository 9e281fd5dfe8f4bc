#include "server/app/open_surface_options.hpp"

#include "core/surface/rake.hpp"
#include "protocol/api/generated/names.hpp"
#include "server/app/tell.hpp"
#include "server/data/dataset_suggestion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace wakesurf::server {

namespace {

/// Uses the suggestion of the data for a rake and all open options, and prints it to standard error.
core::Result<void> begin_with_suggestion(SurfaceRequest& request,
                                         const SurfaceOptions& options,
                                         const LoadedDataset& dataset,
                                         std::stop_token stop) {
    const auto scene =
        suggest_for(dataset.info, *dataset.flow, dataset.store.get(), std::move(stop));
    if (!scene)
        return tl::unexpected(scene.error());
    core::SurfaceParameters& parameters = request.parameters;
    request.rake = scene->rake;
    request.rake.seeds = options.seeds;
    std::string points;
    for (const core::Vec3& p : scene->rake.points)
        points += fmt::format("{}{:g},{:g},{:g}", points.empty() ? "" : " ", p.x, p.y, p.z);
    tell(stderr, "wakesurf: without --rake: {} It is --rake \"{}\"{}\n", scene->why, points,
         scene->rake.kind == core::Rake::Kind::Circle ? " --rake-kind circle" : "");
    const auto same =
        std::ranges::find(scene->surfaces, parameters.kind, &core::SurfaceParameters::kind);
    if (same == scene->surfaces.end())
        return {};
    if (!request.from && !request.to && !parameters.direction) {
        request.from = same->from;
        request.to = same->to;
    }
    if (parameters.separation == 0.0)
        parameters.separation = same->separation;
    if (!parameters.sweep && !parameters.rake2)
        parameters.sweep = same->sweep;
    return {};
}

/// Chooses the field of a stream surface whose time is open: of a steady solver's iterations the last, else the first
/// stored one in which the fluid moves along the rake; the very first if it moves in none. Looks at 16 at most.
core::Result<void> choose_field_time(SurfaceRequest& request,
                                     const LoadedDataset& dataset,
                                     const std::stop_token& stop) {
    constexpr std::size_t most_looks = 16;
    const auto& times = dataset.info.times;
    if (request.from || request.parameters.kind != core::SurfaceKind::Stream ||
        request.parameters.direction == core::Direction::Backward || times.size() < 2)
        return {};
    if (dataset.info.time_unit == core::iterations) {
        request.from = times.back();
        tell(stderr, "wakesurf: without --from: the last iteration, {:g}\n", times.back());
        return {};
    }
    const core::SeedingCurve rake(request.rake);
    std::vector<core::Vec3> points;
    for (int i = 0; i <= 16; ++i)
        points.push_back(rake.at(i / 16.0));
    std::vector<core::Vec3> velocities(points.size());
    const std::size_t apart = (times.size() + most_looks - 1) / most_looks;
    for (std::size_t k = 0; k < times.size(); k += apart) {
        const std::vector<double> when(points.size(), times[k]);
        if (auto sampled = dataset.flow->sample(points, when, velocities, stop); !sampled)
            return sampled;
        if (std::ranges::all_of(velocities,
                                [](const core::Vec3& v) { return !(glm::length(v) > 0.0); }))
            continue;
        if (k > 0) {
            request.from = times[k];
            tell(stderr, "wakesurf: without --from: {:g}, because the fluid is at rest before\n",
                 times[k]);
        }
        return {};
    }
    return {};
}

/// Says that one stored time is a flow that stands still, and chooses how long particles are followed if that is
/// open: as long as the surface of a suggested rake would be.
core::Result<void> let_it_stand_still(SurfaceRequest& request,
                                      const LoadedDataset& dataset,
                                      const std::stop_token& stop) {
    const auto& times = dataset.info.times;
    const core::SurfaceKind kind = request.parameters.kind;
    if (dataset.store == nullptr || times.size() != 1 || kind == core::SurfaceKind::Stream ||
        kind == core::SurfaceKind::Level)
        return {};
    tell(stderr, "wakesurf: the data have one time, {:g}: the flow is taken to stand still\n",
         times.front());
    if (request.to)
        return {};
    const auto scene = suggest_for(dataset.info, *dataset.flow, dataset.store.get(), stop);
    if (!scene)
        return tl::unexpected(scene.error());
    const auto same = std::ranges::find(scene->surfaces, kind, &core::SurfaceParameters::kind);
    if (same == scene->surfaces.end())
        return {};
    const bool backward = request.parameters.direction == core::Direction::Backward;
    const double long_enough = same->to - same->from;
    request.to = request.from.value_or(times.front()) + (backward ? -long_enough : long_enough);
    tell(stderr, "wakesurf: without --to: {:g}, long enough for a usual rake\n", *request.to);
    return {};
}

} // namespace

core::Result<void> choose_open_options(SurfaceRequest& request,
                                       const SurfaceOptions& options,
                                       const LoadedDataset& dataset,
                                       const std::stop_token& stop) {
    if (options.rake.empty() && request.parameters.kind != core::SurfaceKind::Level)
        if (auto begun = begin_with_suggestion(request, options, dataset, stop); !begun)
            return begun;
    if (auto chosen = choose_field_time(request, dataset, stop); !chosen)
        return chosen;
    if (auto still = let_it_stand_still(request, dataset, stop); !still)
        return still;
    choose_times(request, dataset.info.times);
    if (dataset.info.time_unit == core::iterations && dataset.info.times.size() > 1 &&
        request.parameters.kind != core::SurfaceKind::Stream)
        tell(stderr,
             "wakesurf: the times are iterations of a steady solver: a {} surface through "
             "them means nothing; --kind stream shows the result, and so do the others once "
             "wakesurf import --times {:g}:{:g} has made a store of it alone\n",
             protocol::name(request.parameters.kind), dataset.info.times.back(),
             dataset.info.times.back());
    return {};
}

void choose_times(SurfaceRequest& request, const std::vector<double>& times) {
    core::SurfaceParameters& parameters = request.parameters;
    const bool backward = parameters.direction == core::Direction::Backward;
    const double first = times.empty() ? 0.0 : backward ? times.back() : times.front();
    const double last = times.empty() ? 0.0 : backward ? times.front() : times.back();
    parameters.from = request.from.value_or(first);
    const bool there = backward ? last < parameters.from : last > parameters.from;
    const double usual = there ? last : parameters.from + (backward ? -10 : 10);
    parameters.to = request.to.value_or(usual);
}

} // namespace wakesurf::server
