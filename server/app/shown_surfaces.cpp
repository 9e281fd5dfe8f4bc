#include "server/app/shown_surfaces.hpp"

#include "core/base/clock.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "server/app/recipe_data.hpp"
#include "server/live/surface_file.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace wakesurf::server {

std::vector<ShownSurface> shown_surfaces(const std::vector<protocol::FoundRecipe>& found) {
    std::vector<ShownSurface> out;
    for (const protocol::FoundRecipe& each : found) {
        protocol::Recipe alone = each.recipe;
        ShownSurface::State state{std::exchange(alone.time, {}), std::exchange(alone.shape, {})};
        auto same = std::ranges::find(out, alone, &ShownSurface::recipe);
        if (same == out.end())
            same = out.insert(out.end(), {std::move(alone), {}});
        same->states.push_back(std::move(state));
    }
    for (ShownSurface& each : out) {
        const core::SurfaceParameters& p = each.recipe.parameters;
        std::ranges::stable_sort(each.states, {}, [&](const ShownSurface::State& state) {
            return core::age_at(p, state.time);
        });
    }
    return out;
}

core::Result<std::vector<double>> times_that_differ(const ShownSurface& shown,
                                                    const LoadedDataset& dataset,
                                                    const core::MemoryAccount& account,
                                                    const std::stop_token& stop) {
    const auto plan = plan_of(shown.recipe, dataset);
    if (!plan)
        return tl::unexpected(plan.error());
    core::WorkMemory memory(account, stop);
    const core::WorkPart work{nullptr, &memory};
    const core::SteadyClock clock;
    std::optional<core::Evolution> evolution;
    std::vector<double> out;
    for (const ShownSurface::State& each : shown.states) {
        std::string shape;
        if (each.time && core::moves(plan->parameters)) {
            if (!evolution) {
                auto begun = core::Evolution::start(*plan, clock, stop, work);
                if (!begun)
                    return tl::unexpected(begun.error());
                evolution = std::move(*begun);
            }
            const auto state = evolution->at(*each.time, stop, work);
            if (!state)
                return tl::unexpected(state.error());
            shape = shape_mark(state->mesh.mesh);
        } else {
            const auto state = core::surface_at(*plan, each.time, clock, stop, work);
            if (!state)
                return tl::unexpected(state.error());
            shape = shape_mark(state->mesh);
        }
        if (shape != each.shape)
            out.push_back(each.time.value_or(plan->parameters.to));
    }
    return out;
}

} // namespace wakesurf::server
