// Streamlines against closed forms; why they end; by any number of threads; within a memory budget.
#include "core/base/memory_account.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/lines/line_seeds.hpp"
#include "core/surface/lines/stream_lines.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace wakesurf::core::stream_lines_test {

namespace {

Result<StreamLines> traced(const Flow& flow,
                           std::vector<Vec3> seeds,
                           const StreamLinesRequest& request,
                           const MemoryAccount& account = MemoryAccount(std::size_t{1} << 33)) {
    WorkMemory memory(account, {}, std::chrono::milliseconds(0), "these lines");
    return trace_stream_lines(request, flow, seeds, memory, {});
}

std::vector<Vec3> on_a_line(const Vec3& a, const Vec3& b, std::uint32_t count) {
    return line_seed_places({LineSeeds::Kind::Line, {a, b}, 0.0, count});
}

} // namespace

TEST(StreamLines, OfAUniformFlowAreStraightAndAsLongAsSpeedTimesTime) {
    const auto flow = make_analytic_flow("uniform?u=3,v=4").value();
    const auto lines = value_of(traced(*flow, {{0, 0, 0}, {0.1, 0, 0}},
                                       {.direction = Direction::Forward, .duration = 0.2}));
    ASSERT_EQ(lines.lines(), 2u);
    EXPECT_NEAR(glm::distance(lines.points[lines.offsets[1] - 1], Vec3(0.6, 0.8, 0)), 0.0, 1e-9);
    EXPECT_NEAR(lines.times[lines.offsets[1] - 1], 0.2, 1e-6);
    for (std::size_t i = 0; i < lines.offsets[1]; ++i) {
        EXPECT_NEAR(lines.points[i].y * 3.0, lines.points[i].x * 4.0, 1e-9);
        EXPECT_NEAR(lines.values[i], 5.0, 1e-5);
    }
    EXPECT_EQ(lines.ends.limit, 2u);
}

TEST(StreamLines, GoBothWaysFromTheirSeedAndEndAtTheDomain) {
    const auto flow = make_analytic_flow("uniform").value();
    const auto lines = value_of(traced(*flow, {{0, 0, 0}}, {}));
    const Box box = flow->domain();
    EXPECT_NEAR(lines.points.front().x, box.lo.x, 1e-6);
    EXPECT_NEAR(lines.points.back().x, box.hi.x, 1e-6);
    EXPECT_EQ(lines.ends.domain, 2u);
    for (const float value : lines.values)
        EXPECT_NEAR(value, 1.0, 1e-6) << "at the border too";
    EXPECT_LT(lines.times.front(), 0.0F);
    EXPECT_GT(lines.times.back(), 0.0F);
}

TEST(StreamLines, OfASolidRotationAreCirclesThatClose) {
    const auto flow = make_analytic_flow("rotation?omega=2,w=0").value();
    const double turn = std::numbers::pi;
    const auto lines =
        value_of(traced(*flow, {{0.5, 0, 0}}, {.direction = Direction::Forward, .duration = turn}));
    EXPECT_LT(glm::distance(lines.points.front(), lines.points.back()), 1e-4);
    for (const Vec3& each : lines.points)
        EXPECT_NEAR(glm::length(each), 0.5, 1e-4);
    // Within a turn of 3 degrees: 120 points, and not many more.
    EXPECT_GE(lines.points.size(), 120u);
    EXPECT_LE(lines.points.size(), 250u);
}

TEST(StreamLines, ThatGoRoundForEverEndAtTheirLength) {
    const auto flow = make_analytic_flow("rotation?w=0").value();
    const auto lines =
        value_of(traced(*flow, {{0.5, 0, 0}}, {.direction = Direction::Forward, .length = 1.25}));
    EXPECT_EQ(lines.ends.limit, 1u);
    EXPECT_NEAR(lines.times.back(), 1.25 / 0.5, 1e-4);
    const auto free = value_of(traced(*flow, {{0.5, 0, 0}}, {.direction = Direction::Forward}));
    EXPECT_EQ(free.ends.limit, 1u);
    EXPECT_NEAR(free.times.back() * 0.5, lengths_in_domain * flow->domain().diagonal(), 0.01);
}

TEST(StreamLines, HaveNoMorePointsThanTheyMayAndSayThatTheyWereCut) {
    const auto flow = make_analytic_flow("rotation?w=0").value();
    const auto lines = value_of(traced(*flow, on_a_line({0.5, 0, 0}, {0.9, 0, 0}, 5),
                                       {.direction = Direction::Both, .most_points = 200}));
    EXPECT_EQ(lines.ends.cut, 10u);
    EXPECT_LE(lines.points.size(), 200u);
    const auto across = make_analytic_flow("uniform").value();
    const auto straight = value_of(traced(*across, on_a_line({-9, 0, 0}, {9, 0, 0}, 2),
                                          {.direction = Direction::Forward, .most_points = 100}));
    EXPECT_EQ(straight.ends.cut, 1u)
        << "the short one has all its points, the long one what is left";
    EXPECT_EQ(straight.points.size(), 100u);
}

TEST(StreamLines, OfSeedsInABodyOrOutsideAreLeftOutAndCounted) {
    const auto flow = make_analytic_flow("sphere?a=0.5").value();
    const Box box = flow->domain();
    const auto lines =
        value_of(traced(*flow, {{0, 0, 0}, {0.1, 0, 0}, {box.hi.x + 1, 0, 0}, {0, 0.8, 0}}, {}));
    EXPECT_EQ(lines.seeds, 4u);
    EXPECT_EQ(lines.outside, 3u);
    EXPECT_EQ(lines.seed, std::vector<std::uint32_t>{3});
    const auto none = value_of(traced(*flow, {{0, 0, 0}}, {}));
    EXPECT_EQ(none.lines(), 0u);
    EXPECT_EQ(none.offsets, std::vector<std::uint32_t>{0});
    EXPECT_FALSE(none.range);
}

TEST(StreamLines, OfDataComeNearerToTheTrueOnesWithTheSquareOfTheSpacing) {
    // Round the axis the linear field's lines are off by what its second derivative makes of a cell.
    const auto error = [](std::uint32_t nodes) {
        const UniformGrid grid{Vec3(-1.0), Vec3(2.0 / (nodes - 1)), {nodes, nodes, 5}};
        const auto source = std::make_shared<tests::SampledSource>(
            grid, std::vector{0.0}, [](const Vec3& x, double) {
                const double k = std::exp(-(x.x * x.x + x.y * x.y));
                return Vec3(-x.y * k, x.x * k, 0.0);
            });
        const auto flow =
            make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
        const auto lines =
            traced(*flow, {{0.6, 0, -0.9}}, {.direction = Direction::Forward, .length = 3.0})
                .value();
        double most = 0.0;
        for (const Vec3& each : lines.points)
            most = std::max(most, std::abs(std::hypot(each.x, each.y) - 0.6));
        return most;
    };
    const double coarse = error(17);
    EXPECT_GT(coarse, 1e-5);
    EXPECT_LT(error(65), coarse / 8.0);
}

TEST(StreamLines, AreTheSameByAnyNumberOfThreads) {
    const auto flow = make_analytic_flow("abc?C=0.7").value();
    const auto seeds = on_a_line(flow->domain().lo, flow->domain().hi, 60);
    const StreamLinesRequest request{.field = GradientField::QCriterion, .duration = 4.0};
    const auto many = value_of(traced(*flow, seeds, request));
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const auto one = value_of(traced(*flow, seeds, request));
    ASSERT_EQ(many.points.size(), one.points.size());
    EXPECT_EQ(many.points, one.points);
    EXPECT_EQ(many.offsets, one.offsets);
    EXPECT_EQ(std::memcmp(many.values.data(), one.values.data(), 4 * one.values.size()), 0);
}

TEST(StreamLines, ThatDoNotFitIntoTheMemoryAreRefused) {
    const auto flow = make_analytic_flow("rotation?w=0").value();
    const MemoryAccount account(1'000'000);
    const auto lines = traced(*flow, on_a_line({0.1, 0, 0}, {0.9, 0, 0}, 4000), {}, account);
    ASSERT_FALSE(lines);
    EXPECT_EQ(lines.error().code, Error::Code::OverLimit);
    EXPECT_NE(lines.error().message.find("these lines"), std::string::npos);
}

} // namespace wakesurf::core::stream_lines_test
