// Streamlines of a dataset from seeds off patches of its boundary, chosen by their names, and along them.
#include "server/data/dataset_lines.hpp"
#include "tests/support/patched_flow.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server::dataset_lines_test {

namespace {

core::Result<core::StreamLines>
lines_at(const std::vector<std::string>& patches,
         core::LineSeeds::Kind kind = core::LineSeeds::Kind::Walls,
         const core::MemoryAccount& account = core::MemoryAccount(std::size_t{1} << 30)) {
    LoadedDataset data;
    data.flow = std::make_shared<tests::PatchedFlow>();
    core::WorkMemory memory(account, {}, std::chrono::milliseconds(0), "these lines");
    const double distance = kind == core::LineSeeds::Kind::Walls ? 0.1 : 0.0;
    return dataset_lines({kind, {}, distance, 40, patches}, {}, data, memory, {});
}

} // namespace

TEST(DatasetLines, BeginOffThePatchesThatAreNamedAlsoWhereTheseAreNoWalls) {
    const auto inlet = value_of(lines_at({"inlet"}));
    ASSERT_EQ(inlet.lines(), 40u);
    for (const core::Vec3& seed : inlet.points)
        EXPECT_NEAR(std::abs(seed.x + 1.0), 0.1, 1e-6);
    const auto two = value_of(lines_at({"floor", "hull"}));
    const auto near_floor =
        std::ranges::count_if(two.points, [](const core::Vec3& seed) { return seed.z < -0.5; });
    EXPECT_GT(near_floor, 30) << "by area";
    EXPECT_LT(near_floor, 40);
    EXPECT_EQ(value_of(lines_at({})).lines(), 40u);
    const auto none = lines_at({"hull", "outlet"});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, core::Error::Code::NotFound);
    EXPECT_EQ(none.error().hint, "they are hull, inlet, floor");
}

TEST(DatasetLines, AlongAWallLieOnItAndFollowWhatFlowsBesideIt) {
    const auto lines = value_of(lines_at({"hull"}, core::LineSeeds::Kind::Along));
    ASSERT_EQ(lines.lines(), 40u);
    EXPECT_EQ(lines.ends.domain, 80u) << "at the border of the wall";
    for (std::size_t i = 0; i < lines.lines(); ++i) {
        const core::Vec3 first = lines.points[lines.offsets[i]];
        const core::Vec3 last = lines.points[lines.offsets[i + 1] - 1];
        EXPECT_NEAR(first.z, 0.0, 1e-12);
        EXPECT_NEAR((last - first).x * 4.0, (last - first).y * 3.0, 1e-6);
        EXPECT_GT((last - first).x, 0.0) << "downstream";
    }
    for (const float value : lines.values)
        EXPECT_FLOAT_EQ(value, 5.0F);
    const auto refused = lines_at({"hull"}, core::LineSeeds::Kind::Along, core::MemoryAccount(100));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, core::Error::Code::OverLimit);
}

} // namespace wakesurf::server::dataset_lines_test
