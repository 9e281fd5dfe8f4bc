// Moving surfaces that share one memory for stepping back.
#include "core/field/analytic_flow.hpp"
#include "server/base/limits.hpp"
#include "server/live/compute/history_budget.hpp"
#include "server/live/surface_build.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <optional>
#include <random>
#include <vector>

namespace wakesurf::server::history_budget_test {

namespace {

using std::chrono::seconds;

/// A history that takes what it may, but never less than one checkpoint while it is there.
struct Made {
    explicit Made(const HistoryBudget& budget)
        : permit(budget, [this](std::size_t most) {
              bytes = most == 0 ? 0 : std::min(bytes, std::max(most, least));
              return bytes;
          }) {}

    void use(HistoryBudget::Time now, std::size_t wanted) {
        bytes = std::min(wanted, permit.begin(now));
        permit.end(bytes);
    }

    static constexpr std::size_t least = 10;
    std::size_t bytes = 0;
    HistoryBudget::Permit permit;
};

SurfaceJob streak(double separation) {
    SurfaceJob job;
    core::SurfaceParameters p;
    const core::Rake rake{core::Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    p.kind = core::SurfaceKind::Streak;
    p.to = 2.0;
    p.separation = separation;
    job.plan = core::plan_surface(*core::make_analytic_flow("abc"), rake, p).value();
    job.lattice = protocol::lattice_over(core::describe_analytic_flow("abc")->bounds);
    return job;
}

SurfacePass at(double time) {
    SurfacePass pass;
    pass.phase = Phase::Final;
    pass.time = time;
    return pass;
}

} // namespace

TEST(HistoryBudget, LetsWhatHasRestedLongestGiveWayFirst) {
    const HistoryBudget budget(1000, 400);
    HistoryBudget::Time now{};
    Made old(budget), fresh(budget), third(budget), fourth(budget);
    old.use(now, 400);
    fresh.use(now += seconds(1), 400);
    EXPECT_EQ(budget.bytes(), 800u);
    now += limits::history_rest - seconds(1);
    fresh.use(now, 400);
    third.use(now += seconds(1), 400);
    EXPECT_EQ(old.bytes, 0u) << "no one has looked at it for long";
    EXPECT_EQ(fresh.bytes, 400u);
    fourth.use(now += seconds(1), 400);
    EXPECT_EQ(fresh.bytes, third.bytes) << "all that are looked at get smaller, none goes";
    EXPECT_EQ(fresh.bytes, 300u);
    EXPECT_EQ(fourth.bytes, 400u);
}

TEST(HistoryBudget, IsNeverExceededWhateverIsUsedAtOnce) {
    std::mt19937 random(3);
    const HistoryBudget budget(1000, 300);
    std::deque<Made> made;
    for (int i = 0; i < 40; ++i)
        made.emplace_back(budget);

    struct Use {
        Made* of;
        std::size_t most;
    };

    std::vector<Use> running;
    HistoryBudget::Time now{};
    for (int step = 0; step < 5000; ++step) {
        now += seconds(random() % 3);
        Made& one = made[random() % made.size()];
        const auto in_use = std::find_if(running.begin(), running.end(),
                                         [&](const Use& use) { return use.of == &one; });
        if (in_use != running.end()) {
            one.bytes = random() % (in_use->most + 1);
            one.permit.end(one.bytes);
            running.erase(in_use);
        } else if (running.size() < 6) {
            const std::size_t most = one.permit.begin(now);
            ASSERT_GT(most, 0u) << "each newcomer gets something";
            ASSERT_LE(most, 300u);
            running.push_back({&one, most});
        } else if (random() % 4 == 0) {
            continue;
        }
        std::size_t sum = 0;
        for (const Use& use : running)
            sum += use.most;
        for (const Made& each : made)
            if (std::none_of(running.begin(), running.end(),
                             [&](const Use& use) { return use.of == &each; }))
                sum += each.bytes;
        ASSERT_EQ(budget.bytes(), sum);
        ASSERT_LE(sum, 1000u) << "step " << step;
    }
}

TEST(HistoryBudget, CountsNothingOfASurfaceThatHasGone) {
    const HistoryBudget budget(1000, 300);
    std::optional<Made> made(budget);
    made->use({}, 200);
    EXPECT_EQ(budget.bytes(), 200u);
    made.reset();
    EXPECT_EQ(budget.bytes(), 0u);
}

TEST(HistoryBudget, TakesFromTheAccountOnlyWhatOthersLeaveAndGivesItBackWhenTheyNeedIt) {
    const core::MemoryAccount account(1000);
    const HistoryBudget budget(600, 300, &account);
    Made one(budget), two(budget);
    one.use({}, 300);
    two.use(HistoryBudget::Time(seconds(1)), 150);
    EXPECT_EQ(account.used(core::MemoryUse::Histories), 450u);
    auto others = account.open(core::MemoryUse::Builds);
    ASSERT_TRUE(others.grow_to(700)) << "150 too much";
    EXPECT_EQ(one.bytes, 0u) << "rested longest";
    EXPECT_EQ(two.bytes, 150u);
    ASSERT_TRUE(others.grow_to(1000));
    EXPECT_EQ(account.used(core::MemoryUse::Histories), 0u);
    one.use(HistoryBudget::Time(seconds(2)), 300);
    EXPECT_EQ(one.bytes, 0u) << "there is none: the surface is stepped from its beginning";
}

TEST(HistoryBudget, SurfacesThatGiveWayShowTheSameAsThoseWithMemoryOfTheirOwn) {
    HandClock clock;
    const HistoryBudget budget(std::size_t{60} << 10, std::size_t{60} << 10);
    std::deque<SurfaceBuild> sharing, alone;
    for (const double separation : {0.3, 0.25, 0.2}) {
        sharing.emplace_back(streak(separation), clock, SurfaceBuild::Memory{nullptr, &budget});
        alone.emplace_back(streak(separation), clock);
    }
    std::mt19937 random(8);
    bool began_anew = false;
    for (int step = 0; step < 60; ++step) {
        const std::size_t which = random() % sharing.size();
        const double time = 0.1 * static_cast<double>(random() % 21);
        clock.time += seconds(random() % 20);
        const auto shared = sharing[which].run(at(time), {});
        const auto own = alone[which].run(at(time), {});
        ASSERT_TRUE(shared && own);
        EXPECT_EQ(shared->statistics.quads, own->statistics.quads) << "at " << time;
        EXPECT_EQ(shared->statistics.max_edge, own->statistics.max_edge) << "at " << time;
        began_anew = began_anew || (shared->wire.key && !own->wire.key);
        EXPECT_LE(budget.bytes(), (std::size_t{60} << 10) + (std::size_t{60} << 10))
            << "what stands alone is not within it";
    }
    EXPECT_TRUE(began_anew) << "the budget was too large to tell";
}

} // namespace wakesurf::server::history_budget_test
