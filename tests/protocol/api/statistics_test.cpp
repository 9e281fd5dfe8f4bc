#include "protocol/api/generated/subscription.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::protocol::statistics_test {

TEST(Statistics, HasTheShapeOfTheContract) {
    core::SurfaceStatistics statistics{.kind = core::SurfaceKind::Path,
                                       .quads = 1,
                                       .vertices = 2,
                                       .steps = 3,
                                       .vertex_steps = 4,
                                       .approximated = 5,
                                       .terminated = {6, 7, 8, 9, 10},
                                       .max_edge = 0.25,
                                       .separation = 0.5,
                                       .requested_separation = 0.25,
                                       .seconds = {1, 2, 3, 4, 10}};
    EXPECT_EQ(written(statistics), nlohmann::json::parse(R"({
        "kind": "path", "quads": 1, "vertices": 2, "steps": 3, "vertexSteps": 4, "approximated": 5,
        "terminated": {"domain": 6, "time": 7, "obstacle": 8, "stagnation": 9, "budget": 10},
        "maxEdge": 0.25, "separation": 0.5, "requestedSeparation": 0.25, "coarsened": true,
        "seconds": {"load": 1.0, "advect": 2.0, "refine": 3.0, "other": 4.0, "total": 10.0}})"));
    statistics.data_end = 8.5;
    EXPECT_EQ(written(statistics)["dataEnd"], 8.5);
}

TEST(Statistics, SaysWhyThereIsNothingToSee) {
    core::SurfaceStatistics statistics;
    EXPECT_FALSE(written(statistics).contains("empty"));
    statistics.empty = {core::Emptiness::Reason::AtRest, "the fluid is at rest", "move the rake"};
    EXPECT_EQ(
        written(statistics)["empty"],
        nlohmann::json::parse(
            R"({"reason": "atRest", "message": "the fluid is at rest", "hint": "move the rake"})"));
}

} // namespace wakesurf::protocol::statistics_test
