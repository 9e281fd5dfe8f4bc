#include "core/dataset/brick_cache.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/support/bricked_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::look_ahead_test {

namespace {

struct Counts {
    std::uint64_t rounds;
    std::uint64_t reads;
};

/// Carries a row of particles through four intervals in ten passes each, two bricks an interval, and counts.
Counts carry(const tests::SampledSource::Velocity& velocity, Vec3 from) {
    const UniformGrid grid{Vec3(0.0), Vec3(0.125), {81, 33, 9}}; // bricks are 1 long
    const auto whole = std::make_shared<tests::SampledSource>(
        grid, std::vector{0.0, 1.0, 2.0, 3.0, 4.0}, velocity);
    const auto source = std::make_shared<tests::BrickedSource>(whole, 8);
    source->at_once = true;
    TimeStepCache::Options options;
    options.by_brick = true;
    options.budget_bytes = std::size_t{64} << 20;
    const auto cache = std::make_shared<TimeStepCache>(source, options);
    const auto flow = make_stored_flow(cache);
    std::vector<Vec3> position;
    for (int i = 0; i < 8; ++i)
        position.push_back(from + Vec3(0.0, 0.0, 0.1 * i));
    std::vector<double> time(8, 0.0);
    std::vector<CurveEnd> end(8, CurveEnd::Running);
    AdvanceOptions advance;
    advance.step = 0.05;
    for (int pass = 1; pass <= 40; ++pass)
        EXPECT_TRUE(flow->advance({position, {}, {}, time, end}, 0.1 * pass, advance, {}));
    EXPECT_EQ(end[0], CurveEnd::Running);
    return {cache->bricks()->status().rounds, cache->bricks()->status().reads};
}

} // namespace

TEST(LookAhead, AFrontThatMovesOnWaitsForItsFirstBricksOnly) {
    const Counts counts =
        carry([](const Vec3&, double) { return Vec3(1.9, 0.0, 0.0); }, Vec3(0.6, 0.5, 0.1));
    EXPECT_LE(counts.rounds, 2u);
    // Nine bricks on the way are needed, each of two time-steps.
    EXPECT_LE(counts.reads, 2u * 18u);
}

TEST(LookAhead, FollowsWaysThatBend) {
    const Vec3 centre(5.0, 2.0, 0.0);
    const auto round = [&](const Vec3& p, double) {
        return Vec3(centre.y - p.y, p.x - centre.x, 0.0);
    };
    EXPECT_LE(carry(round, Vec3(3.2, 2.0, 0.1)).rounds, 4u);
}

TEST(LookAhead, StopsAtTheBorderOfTheGrid) {
    const Counts counts =
        carry([](const Vec3&, double) { return Vec3(0.01, 0.0, 0.0); }, Vec3(9.9, 3.9, 0.1));
    EXPECT_LE(counts.rounds, 1u);
    EXPECT_LE(counts.reads, 5u);
}

} // namespace wakesurf::core::look_ahead_test
