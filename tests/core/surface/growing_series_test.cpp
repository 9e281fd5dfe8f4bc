// A surface whose times lie inside the data is the same before and after more data have come.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::growing_series_test {

using namespace tests;

namespace {

/// Says that its time-steps are as large as one likes.
class LargeSource final : public TimeStepSource {
  public:
    LargeSource(std::size_t steps, std::size_t bytes)
        : steps_(UniformGrid{{-1, -1, -0.25}, {0.1, 0.1, 0.25}, {31, 21, 3}},
                 times(steps),
                 [](const Vec3& p, double t) {
                     const double r2 = p.x * p.x + p.y * p.y + 0.02;
                     return Vec3(0.3 - p.y / r2, p.x / r2, 0.1 * std::sin(t));
                 }),
          bytes_(bytes) {}

    const Grid& grid() const override { return steps_.grid(); }

    const SolidMask& mask() const override { return steps_.mask(); }

    const std::vector<double>& times() const override { return steps_.times(); }

    bool ready(std::size_t) const override { return true; }

    std::size_t bytes_per_step() const override { return bytes_; }

    Result<std::shared_ptr<const TimeStep>> load(std::size_t index,
                                                 std::stop_token stop) const override {
        return steps_.load(index, std::move(stop));
    }

  private:
    static std::vector<double> times(std::size_t steps) {
        std::vector<double> out;
        for (std::size_t i = 0; i < steps; ++i)
            out.push_back(0.5 * static_cast<double>(i));
        return out;
    }

    SampledSource steps_;
    std::size_t bytes_;
};

std::unique_ptr<Flow> series(std::size_t steps, std::size_t bytes) {
    TimeStepCache::Options options;
    options.budget_bytes = std::size_t{1} << 40;
    return make_stored_flow(
        std::make_shared<TimeStepCache>(std::make_shared<LargeSource>(steps, bytes), options));
}

QuadComplex streak(const Flow& flow, double to) {
    SurfaceParameters p{.kind = SurfaceKind::Streak, .to = to, .separation = 0.1};
    Rake rake{.points = {{-0.6, -0.4, 0.0}, {-0.1, 0.3, 0.0}}, .seeds = 9};
    const auto surface = build_surface(flow, rake, p);
    EXPECT_TRUE(surface) << surface.error().message;
    return surface ? surface->mesh : QuadComplex{};
}

constexpr std::size_t gibi = std::size_t{1} << 30;

} // namespace

TEST(GrowingSeries, AStreakSurfaceIsTheSameBeforeAndAfterItsSeriesGrew) {
    const QuadComplex whole = streak(*series(4, gibi), 1.4);
    ASSERT_GT(whole.cells.size(), 50U);
    const QuadComplex grown = streak(*series(12, gibi), 1.4);
    EXPECT_EQ(whole.position, grown.position);
    EXPECT_EQ(whole.approximated, grown.approximated);
    // That its data are few does matter here.
    EXPECT_NE(whole.position, streak(*series(4, 2 * gibi), 1.4).position);
}

TEST(GrowingSeries, OnlyTheTimeStepsThatATimeLiesBetweenCount) {
    const auto flow = series(12, gibi); // 0, 0.5 .. 5.5
    EXPECT_TRUE(flow->few_data(0.0, 1.5));
    EXPECT_FALSE(flow->few_data(0.0, 1.6));
    EXPECT_TRUE(flow->few_data(1.9, 0.6));
    EXPECT_FALSE(flow->few_data(2.1, 0.4));
    EXPECT_TRUE(flow->few_data(5.5, 4.0));
    EXPECT_TRUE(series(1, gibi)->few_data(0.0, 3.0));
}

} // namespace wakesurf::core::growing_series_test
