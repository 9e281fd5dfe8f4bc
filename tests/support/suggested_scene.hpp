// The scene suggested first for a flow.
#pragma once

#include "core/surface/suggestion/scene_suggestion.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace wakesurf::tests {

inline std::vector<double> times(std::size_t count, double step) {
    std::vector<double> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(static_cast<double>(i) * step);
    return out;
}

inline core::SceneSuggestion suggested(const core::Flow& flow,
                                       const core::SeriesFacts& series,
                                       const core::WallGeometry& walls = {}) {
    auto scene = core::suggest_scene(flow, series, walls, {});
    EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().message);
    return scene.value_or(core::SceneSuggestion{});
}

} // namespace wakesurf::tests
