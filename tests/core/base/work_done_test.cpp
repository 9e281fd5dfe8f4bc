#include "core/base/clock.hpp"
#include "core/base/work_done.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/surface/surface_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace wakesurf::core::work_done_test {

namespace {

/// Notes how far the work is whenever it looks at the time.
class Onlooker final : public Clock {
  public:
    explicit Onlooker(const WorkDone& work) : work_(work) {}

    std::chrono::steady_clock::time_point now() const override {
        seen.push_back(work_.fraction());
        return {};
    }

    mutable std::vector<double> seen;

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
            SurfaceParameters p;
            p.kind = kind;
            p.to = 4.0;
            p.separation = 0.1;
            p.direction = direction;
            const bool moving = kind == SurfaceKind::Streak || kind == SurfaceKind::Time;
            if (moving && direction == Direction::Both)
                continue;
            if (kind == SurfaceKind::Time)
                p.sweep = Vec3(1, 0, 0);
            WorkDone work;
            const Onlooker clock(work);
            ASSERT_TRUE(build_surface(*flow, rake, p, {}, clock, &work));
            EXPECT_EQ(work.fraction(), 1.0) << static_cast<int>(kind);
            EXPECT_TRUE(std::is_sorted(clock.seen.begin(), clock.seen.end()));
            const auto between =
                std::count_if(clock.seen.begin(), clock.seen.end(),
                              [](double each) { return each > 0.0 && each < 1.0; });
            EXPECT_GT(between, 0) << static_cast<int>(kind);
        }
}

} // namespace wakesurf::core::work_done_test
