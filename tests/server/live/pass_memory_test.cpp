// What a pass of a surface tells the account of memory against what the heap really holds meanwhile: the budget of the process is kept
// only as far as the two agree.
#include "core/base/work_memory.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/surface/moving/surface_history.hpp"
#include "server/live/surface_build.hpp"
#include "tests/support/server/counted_heap.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::pass_memory_test {

namespace {

using core::SurfaceKind;

constexpr std::size_t budget = std::size_t{1} << 40;
constexpr std::size_t slack = std::size_t{1} << 20;

SurfaceJob large(SurfaceKind kind, std::size_t fields) {
    SurfaceJob job;
    core::SurfaceParameters p;
    const core::Rake rake{core::Rake::Kind::Line, {{-2, -1, 0.2}, {-2, 1, 3}}, 200};
    p.kind = kind;
    p.to = 4.0;
    p.accuracy = core::Accuracy::Fast;
    // So that none needs less than 5 MB or more than 30.
    p.separation = kind == SurfaceKind::Time ? 0.09 : kind == SurfaceKind::Streak ? 0.075 : 0.06;
    if (kind == SurfaceKind::Time)
        p.sweep = core::Vec3{3, 0, 0};
    job.plan = core::plan_surface(*core::make_analytic_flow("abc"), rake, p).value();
    using Source = SurfaceField::Source;
    const SurfaceField all[]{{"vorticity", Source::Gradient},
                             {"q_criterion", Source::Gradient},
                             {"deformation", Source::Deformation},
                             {"approximated", Source::Approximated}};
    job.fields.assign(all, all + fields);
    job.lattice = protocol::lattice_over({{-60, -60, -60}, {60, 60, 60}});
    return job;
}

struct Case {
    const char* name;
    SurfaceKind kind;
    std::size_t fields;
    std::optional<double> time;
};

class PassMemory : public testing::TestWithParam<Case> {};

} // namespace

TEST_P(PassMemory, IsToldToTheAccountBeforeItIsTaken) {
    const Case& what = GetParam();
    const core::MemoryAccount account(budget);
    const HistoryBudget histories(0, 0, &account);
    const core::SteadyClock clock;
    const SurfaceJob job = large(what.kind, what.fields);
    SurfaceBuild build(job, clock, {&account, &histories});
    std::size_t quads = 0;
    for (const double part : {1.0, 0.97}) { // a first state, then a change of it
        const tests::CountedHeap heap(account);
        const auto before = account.used();
        auto time = what.time;
        if (time)
            *time *= part;
        const auto update = build.run({Phase::Final, 0, time, 0.0}, {});
        ASSERT_TRUE(update) << update.error().message;
        quads = update->statistics.quads;
        EXPECT_LT(heap.most_untold(), slack + heap.most() / 8);
        EXPECT_LT(heap.most_told() - before, slack + 5 * heap.most() / 2)
            << "it keeps others waiting for what it does not take";
    }
    EXPECT_GT(quads, 4'000u);
}

TEST_P(PassMemory, TakesNoMoreOnceItHasBeenRefused) {
    const Case& what = GetParam();
    const core::SteadyClock clock;
    const SurfaceJob job = large(what.kind, what.fields);
    const SurfacePass whole{Phase::Final, 0, what.time, 0.0};
    std::size_t needed = 0;
    {
        const core::MemoryAccount account(budget);
        const HistoryBudget histories(0, 0, &account);
        SurfaceBuild build(job, clock, {&account, &histories});
        const tests::CountedHeap heap(account);
        ASSERT_TRUE(build.run(whole, {}));
        needed = heap.most_told();
    }
    for (const double part : {0.7, 0.4}) {
        const core::MemoryAccount account(static_cast<std::size_t>(part * double(needed)));
        const HistoryBudget histories(0, 0, &account);
        SurfaceBuild build(job, clock, {&account, &histories});
        const tests::CountedHeap heap(account);
        const auto update = build.run(whole, {});
        ASSERT_FALSE(update) << part;
        EXPECT_EQ(update.error().code, core::Error::Code::OverLimit);
        EXPECT_LT(heap.most_untold(), slack + heap.most() / 8) << part;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEachKind,
                         PassMemory,
                         testing::Values(Case{"Stream", SurfaceKind::Stream, 0, {}},
                                         Case{"StreamWithFields", SurfaceKind::Stream, 4, {}},
                                         Case{"Path", SurfaceKind::Path, 0, {}},
                                         Case{"PathWithFieldsAtATime", SurfaceKind::Path, 4, 3.0},
                                         Case{"Streak", SurfaceKind::Streak, 0, {}},
                                         Case{"StreakWithFieldsAtATime", SurfaceKind::Streak, 4,
                                              3.0},
                                         Case{"Time", SurfaceKind::Time, 0, {}},
                                         Case{"TimeWithFieldsAtATime", SurfaceKind::Time, 4, 3.0}),
                         [](const auto& each) { return each.param.name; });

TEST(SurfaceHistoryMemory, IsNotTakenByAStepThatFindsNone) {
    const SurfaceJob job = large(SurfaceKind::Time, 0);
    const core::SteadyClock clock;
    auto moving = core::MovingSurface::start(job.plan, {}, clock);
    ASSERT_TRUE(moving);
    const std::size_t size = moving->state().bytes();
    core::SurfaceHistory history(std::move(*moving), 0);
    const core::MemoryAccount account(1);
    core::WorkMemory memory(account, {}, std::chrono::milliseconds(0));
    const tests::CountedHeap heap(account);
    const auto refused = history.at(3.0, {}, {nullptr, &memory});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, core::Error::Code::OverLimit);
    EXPECT_TRUE(memory.exhausted());
    EXPECT_LT(heap.most(), size / 4);
    EXPECT_TRUE(history.at(3.0, {})) << "it goes on from its beginning";
}

} // namespace wakesurf::server::pass_memory_test
