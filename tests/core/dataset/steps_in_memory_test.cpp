#include "core/dataset/steps_in_memory.hpp"
#include "core/field/stored_flow.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace wakesurf::core::steps_in_memory_test {

namespace {

const UniformGrid grid{Vec3(0.0), Vec3(1.0), {2, 2, 2}};

std::vector<float> everywhere(float speed) {
    std::vector<float> values(3 * grid.nodes(), 0.0F);
    for (std::size_t node = 0; node < grid.nodes(); ++node)
        values[3 * node] = speed;
    return values;
}

Error refusal(std::vector<double> times,
              std::vector<std::vector<float>> arrays,
              SolidMask mask = {}) {
    const auto made = StepsInMemory::make(grid, std::move(times), {arrays.begin(), arrays.end()},
                                          std::move(mask));
    return made ? Error{} : made.error();
}

} // namespace

TEST(StepsInMemory, AreAFlowBetweenTheirTimes) {
    const std::vector<std::vector<float>> arrays{everywhere(1.0F), everywhere(3.0F)};
    const auto steps = StepsInMemory::make(grid, {10.0, 12.0}, {arrays.begin(), arrays.end()});
    ASSERT_TRUE(steps);
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(*steps, TimeStepCache::Options{}));
    const Vec3 place(0.5);
    const double time = 10.5;
    Vec3 velocity;
    ASSERT_TRUE(flow->sample({&place, 1}, {&time, 1}, {&velocity, 1}, {}));
    EXPECT_EQ(velocity, Vec3(1.5, 0.0, 0.0));
}

TEST(StepsInMemory, HandOutWhatTheyHaveWithoutCopyingItAgain) {
    const std::vector<std::vector<float>> arrays{everywhere(1.0F)};
    const auto steps = StepsInMemory::make(grid, {0.0}, {arrays.begin(), arrays.end()});
    ASSERT_TRUE(steps);
    EXPECT_EQ((*steps)->load(0, {}).value(), (*steps)->load(0, {}).value());
    EXPECT_EQ((*steps)->load(1, {}).error().code, Error::Code::NotFound);
}

TEST(StepsInMemory, MarkTimeStepsWithGaps) {
    std::vector<std::vector<float>> arrays{everywhere(1.0F), everywhere(1.0F)};
    arrays[1][5] = std::numeric_limits<float>::quiet_NaN();
    const auto steps = StepsInMemory::make(grid, {0.0, 1.0}, {arrays.begin(), arrays.end()});
    ASSERT_TRUE(steps);
    EXPECT_FALSE((*steps)->load(0, {}).value()->gaps);
    EXPECT_TRUE((*steps)->load(1, {}).value()->gaps);
}

TEST(StepsInMemory, AreRefusedWhereSizesDoNotMatchOrTimesDoNotRise) {
    EXPECT_EQ(refusal({0.0}, {everywhere(1.0F)}).message, "");
    EXPECT_EQ(refusal({0.0, 0.0}, {everywhere(1.0F), everywhere(1.0F)}).message,
              "the times do not rise strictly");
    EXPECT_EQ(refusal({}, {}).message, "the times do not rise strictly");
    EXPECT_EQ(refusal({0.0}, {}).message, "0 velocity arrays for 1 times");
    EXPECT_EQ(refusal({0.0}, {{1.0F}}).message,
              "time-step 0 has 1 numbers, not 3 for each of 8 nodes");
    EXPECT_EQ(refusal({0.0}, {everywhere(1.0F)}, {{1}}).message,
              "the mask has 1 bytes for 8 nodes");
}

} // namespace wakesurf::core::steps_in_memory_test
