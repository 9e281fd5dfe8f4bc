// The suggested beginning for a dataset: the one answer of `wakesurf surface` without a rake, of
// dataset.suggest, and so of the page.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/surface/suggestion/scene_suggestion.hpp"
#include "store/store_reader.hpp"

#include <stop_token>

namespace wakesurf::server {

/// Suggests a scene from the present time-steps. @param store  null for a built-in flow
/// Cost: as core::suggest_scene, and the walls are read. Error: as that, and as reading the walls.
core::Result<core::SceneSuggestion> suggest_for(const core::DatasetInfo& info,
                                                const core::Flow& flow,
                                                const store::StoreReader* store,
                                                std::stop_token stop);

} // namespace wakesurf::server
