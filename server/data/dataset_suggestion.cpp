#include "server/data/dataset_suggestion.hpp"

#include <utility>

namespace wakesurf::server {

core::Result<core::SceneSuggestion> suggest_for(const core::DatasetInfo& info,
                                                const core::Flow& flow,
                                                const store::StoreReader* store,
                                                std::stop_token stop) {
    core::SeriesFacts series{{}, info.steady, info.bytes_per_step};
    for (std::size_t i = 0; i < info.times.size(); ++i)
        if (store == nullptr || store->ready(i))
            series.times.push_back(info.times[i]);
        else
            break;
    if (series.times.empty())
        series.times.push_back(0.0);
    if (store != nullptr)
        if (const auto* mesh = std::get_if<core::CellMesh>(&store->grid()))
            series.axis = mesh->axis;
    const auto walls = (store != nullptr ? store->load_walls() : flow.walls()).map(core::body_of);
    if (!walls)
        return tl::unexpected(walls.error());
    return core::suggest_scene(flow, series, *walls, std::move(stop));
}

} // namespace wakesurf::server
