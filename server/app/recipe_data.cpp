#include "server/app/recipe_data.hpp"

#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/level/level_surface.hpp"
#include "server/data/surface_scalars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace wakesurf::server {

std::string data_difference(const LoadedDataset& dataset, const protocol::Recipe& recipe) {
    const auto known = [](const std::string& flow) {
        return flow.empty() ? "stored data" : "flow:" + flow;
    };
    if (dataset.flow_text != recipe.flow)
        return fmt::format("the file was made from {}, not from {}", known(recipe.flow),
                           known(dataset.flow_text));
    if (!dataset.store || !dataset.store->contradicts(recipe.values))
        return {};
    const auto other = [&](std::size_t word) {
        std::string_view rest = recipe.values;
        for (; word > 0 && !rest.empty(); --word)
            rest.remove_prefix(std::min(rest.find(' '), rest.size() - 1) + 1);
        return dataset.store->contradicts(rest.substr(0, rest.find(' ')));
    };
    return other(0)   ? "they have another grid or other fields, or are stored in another way"
           : other(1) ? "they have other values, from the first time-step on"
                      : "they have other values in a later time-step";
}

core::Result<core::SurfacePlan> plan_of(const protocol::Recipe& recipe,
                                        const LoadedDataset& dataset) {
    auto plan = core::plan_surface(dataset.flow, recipe.rake, recipe.parameters);
    if (!plan)
        return plan;
    if (auto there = core::take_levels(*plan, dataset.levels); !there)
        return tl::unexpected(there.error());
    std::vector<std::string> fields = recipe.fields;
    std::erase_if(fields, core::is_twin_name);
    if (auto known = check_fields(dataset, fields); !known)
        return tl::unexpected(known.error());
    return plan;
}

} // namespace wakesurf::server
