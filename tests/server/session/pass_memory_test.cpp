// What a pass of a surface tells the account of memory against what the heap really holds meanwhile: the budget of the process is kept
// only as far as the two agree.
#include "core/field/analytic_flow.hpp"
#include "server/session/surface_build.hpp"
#include "tests/support/server/counted_heap.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server {

namespace {

using core::SurfaceKind;

constexpr std::size_t budget = std::size_t{1} << 40;
constexpr std::size_t slack = std::size_t{1} << 20;

SurfaceJob large(SurfaceKind kind, std::size_t fields) {
    SurfaceJob job;
    job.rake = {core::Rake::Kind::Line, {{-2, -1, 0.2}, {-2, 1, 3}}, 200};
    job.parameters.kind = kind;
    job.parameters.to = 4.0;
    job.parameters.accuracy = core::Accuracy::Fast;
    job.parameters.separation = 0.06;
    if (kind == SurfaceKind::Time)
        job.parameters.sweep = core::Vec3{3, 0, 0};
    job.flow = *core::make_analytic_flow("abc");
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

} // namespace wakesurf::server
