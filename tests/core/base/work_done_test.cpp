#include "core/base/clock.hpp"
#include "core/base/work_done.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <vector>

namespace wakesurf::core::work_done_test {

namespace {

/// Notes how far the work is whenever it looks at the time.
class ObservingClock final : public Clock {
  public:
    explicit ObservingClock(const WorkDone& work) : work_(work) {}

    std::chrono::steady_clock::time_point now() const override {
        seen.push_back(work_.fraction());
        times.push_back(work_.time());
        quads.push_back(work_.quads());
        return {};
    }

    /// How often in a row, at most, it looked and nothing had moved on.
    std::ptrdiff_t longest_standstill() const {
        std::ptrdiff_t longest = 0;
        for (auto at = seen.begin(); at != seen.end();) {
            const auto next = std::upper_bound(at, seen.end(), *at);
            longest = std::max(longest, next - at);
            at = next;
        }
        return longest;
    }

    mutable std::vector<double> seen;
    mutable std::vector<std::optional<double>> times;
    mutable std::vector<std::uint64_t> quads;

  private:
    const WorkDone& work_;
};

} // namespace

TEST(WorkDone, NeverGoesBackWhoeverTells) {
    WorkDone work;
    EXPECT_EQ(work.fraction(), 0.0);
    work.reached(0.5);
    work.reached(0.25);
    EXPECT_EQ(work.fraction(), 0.5);
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&work, i] {
                for (int n = 0; n < 1000; ++n)
                    work.reached((n * 4 + i) / 4000.0);
            });
    }
    EXPECT_EQ(work.fraction(), 3999 / 4000.0);
    work.reached(7.0);
    EXPECT_EQ(work.fraction(), 1.0);
}

TEST(WorkDone, PartsFollowEachOther) {
    WorkDone work;
    const WorkPart whole(&work);
    whole.part(0, 2).part(1, 2).reached(0.5);
    EXPECT_EQ(work.fraction(), 0.375);
    whole.part(1, 2).reached(0.0);
    EXPECT_EQ(work.fraction(), 0.5);
    WorkPart().reached(1.0);
    EXPECT_EQ(work.fraction(), 0.5);
}

TEST(WorkDone, IsToldOnTheWayToASurfaceOfAnyKindAndToItsEnd) {
    const auto flow = *make_analytic_flow("abc");
    const Rake rake{Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    for (const SurfaceKind kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const Direction direction : {Direction::Forward, Direction::Both}) {
            SurfaceParameters p{.kind = kind, .to = 4.0, .direction = direction, .separation = 0.1};
            const bool moving = kind == SurfaceKind::Streak || kind == SurfaceKind::Time;
            if (moving && direction == Direction::Both)
                continue;
            if (kind == SurfaceKind::Time)
                p.sweep = Vec3(1, 0, 0);
            WorkDone work;
            const ObservingClock clock(work);
            ASSERT_TRUE(build_surface(*flow, rake, p, {}, clock, &work));
            EXPECT_EQ(work.fraction(), 1.0) << static_cast<int>(kind);
            EXPECT_TRUE(std::is_sorted(clock.seen.begin(), clock.seen.end()));
            const auto between =
                std::count_if(clock.seen.begin(), clock.seen.end(),
                              [](double each) { return each > 0.0 && each < 1.0; });
            EXPECT_GT(between, 0) << static_cast<int>(kind);
        }
}

TEST(WorkDone, GoesOnFromWhereItIsWhereWorkIsBegunAgain) {
    WorkDone work;
    const WorkPart half = WorkPart(&work).between(0.0, 0.5);
    half.reached(0.5);
    half.rest().reached(0.5);
    EXPECT_EQ(work.fraction(), 0.375);
    half.rest().between(0.0, 0.5).reached(1.0);
    EXPECT_EQ(work.fraction(), 0.4375);
    WorkPart(&work).reached(0.75);
    half.rest().reached(1.0);
    EXPECT_EQ(work.fraction(), 0.75) << "it was done already";
}

TEST(WorkDone, KeepsTheFarthestTimeWhicheverWayTimeRuns) {
    WorkDone work;
    EXPECT_FALSE(work.time());
    work.came_to(8.0, 10.0);
    work.came_to(9.0, 10.0);
    EXPECT_EQ(work.time(), 8.0);
    work.came_to(7.5, 10.0);
    EXPECT_EQ(work.time(), 7.5);
}

TEST(WorkDone, NeverStandsStillWhileASurfaceMovesNorRunsBackward) {
    const auto flow = *make_analytic_flow("abc");
    const Rake rake{Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    for (const double to : {4.0, -4.0})
        for (const std::uint64_t most : {1'000'000, 900}) { // which has it begun again, coarser
            SurfaceParameters p{
                .kind = SurfaceKind::Streak, .to = to, .separation = 0.1, .max_quads = most};
            WorkDone work;
            const ObservingClock clock(work);
            const auto surface = build_surface(*flow, rake, p, {}, clock, &work);
            ASSERT_TRUE(surface) << surface.error().message;
            EXPECT_EQ(surface->statistics.coarsened(), most == 900);
            EXPECT_TRUE(std::is_sorted(clock.seen.begin(), clock.seen.end()));
            EXPECT_LE(clock.longest_standstill(), 8) << "two steps look at the clock as often";
            EXPECT_EQ(work.time(), to);
            EXPECT_EQ(work.quads(), surface->statistics.quads);
            for (std::size_t i = 1; i < clock.times.size(); ++i) {
                if (clock.times[i - 1]) {
                    EXPECT_GE(std::abs(*clock.times[i]), std::abs(*clock.times[i - 1]));
                }
            }
            EXPECT_GT(
                std::ranges::count_if(
                    clock.quads, [&](auto n) { return n > 0 && n < surface->statistics.quads; }),
                0);
        }
}

} // namespace wakesurf::core::work_done_test
