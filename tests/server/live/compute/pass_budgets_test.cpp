// What early passes learn from the ones before, on a machine whose times follow from the quads.
#include "server/live/compute/pass_budgets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace wakesurf::server::pass_budgets_test {

namespace {

using Phase = PassBudgets::Phase;

/// A surface whose quads are area / separation^2, rebuilt in steps of 1.25 where they are too many.
struct Machine {
    double seconds_a_quad;
    double asked = 0.001;  ///< separation
    double coarsest = 1e3; ///< separation beyond which none is looked for
    double area = 1.0;
    int attempts = 0; ///< of the newest pass

    /// @return  s; nothing: it was refused
    std::optional<double> try_pass(PassBudgets& budgets, Phase phase) {
        double separation = std::max(asked, budgets.separation(phase));
        double quads = 0.0, seconds = 0.0;
        for (attempts = 1;; ++attempts, separation *= 1.25) {
            quads = area / (separation * separation);
            const double built = std::min(quads, static_cast<double>(budgets.quads(phase)));
            seconds += seconds_a_quad * built;
            if (quads <= built)
                break;
            if (separation >= coarsest) {
                budgets.too_many(phase, seconds);
                return std::nullopt;
            }
        }
        core::SurfaceStatistics statistics;
        statistics.quads = static_cast<std::uint64_t>(quads);
        statistics.separation = separation;
        budgets.took(phase, seconds, statistics, asked, 1'000'000);
        return seconds;
    }

    double pass(PassBudgets& budgets, Phase phase) { return try_pass(budgets, phase).value(); }
};

/// Returns the budgets after ten coarse passes of the machine's surface.
PassBudgets settled(Machine& machine) {
    PassBudgets budgets(true);
    for (int edit = 0; edit < 10; ++edit)
        machine.pass(budgets, Phase::Coarse);
    return budgets;
}

} // namespace

TEST(PassBudgets, FindsTheSeparationOfCoarsePassesOnceAndNotAtEveryEdit) {
    PassBudgets budgets(true);
    Machine machine{2e-6};
    machine.pass(budgets, Phase::Coarse);
    EXPECT_GT(machine.attempts, 5);
    for (int edit = 0; edit < 20; ++edit) {
        budgets.forget(); // what is asked for changes at every edit
        machine.pass(budgets, Phase::Coarse);
        EXPECT_EQ(machine.attempts, 1) << edit;
    }
    EXPECT_NEAR(machine.pass(budgets, Phase::Coarse), 0.0035, 0.0005);
}

TEST(PassBudgets, PlansARefinedPassByWhatTheCoarseOneTook) {
    // As in large meshes of cells: a thousand times as long a quad.
    for (const double seconds_a_quad : {2e-6, 2e-5, 2e-4, 2e-3}) {
        PassBudgets budgets(false);
        Machine machine{seconds_a_quad};
        machine.pass(budgets, Phase::Coarse);
        const double coarse = machine.pass(budgets, Phase::Coarse);
        ASSERT_TRUE(budgets.refined_too());
        EXPECT_LT(machine.pass(budgets, Phase::Refined), std::max(0.16, 5.0 * coarse))
            << seconds_a_quad;
    }
}

TEST(PassBudgets, MakesNoRefinedPassThatTakesAboutAsLongAsTheFinalOne) {
    PassBudgets budgets(false);
    Machine machine{2e-3, 0.03};
    machine.pass(budgets, Phase::Coarse);
    EXPECT_FALSE(budgets.refined_too());
}

TEST(PassBudgets, GoesOnAtOnceWhereASurfaceGrowsAThirdLarger) {
    Machine machine{2e-6};
    PassBudgets budgets = settled(machine);
    machine.seconds_a_quad *= 1.3;
    const double quads = 1.0 / std::pow(budgets.separation(Phase::Coarse), 2);
    EXPECT_LT(1.3 * quads, static_cast<double>(budgets.quads(Phase::Coarse)));
    machine.pass(budgets, Phase::Coarse);
    EXPECT_EQ(machine.attempts, 1);
}

TEST(PassBudgets, MakesLessOfAPassThatANewerEditCutShort) {
    Machine machine{2e-6};
    PassBudgets budgets = settled(machine);
    const double separation = budgets.separation(Phase::Coarse);
    const auto quads = budgets.quads(Phase::Coarse);
    budgets.cut_short(Phase::Coarse, 0.001); // within its time
    EXPECT_EQ(budgets.separation(Phase::Coarse), separation);
    budgets.cut_short(Phase::Coarse, 0.014);
    EXPECT_NEAR(budgets.separation(Phase::Coarse), 2.0 * separation, 1e-9);
    EXPECT_NEAR(static_cast<double>(budgets.quads(Phase::Coarse)), static_cast<double>(quads) / 4.0,
                2.0);
}

TEST(PassBudgets, AllowsASurfaceThatHasGrownAHundredfoldAPassAgainAfterFiveRefusals) {
    for (const double grown : {3.0, 10.0, 100.0}) {
        Machine machine{2e-6};
        PassBudgets budgets = settled(machine);
        machine.coarsest = budgets.separation(Phase::Coarse);
        machine.area *= grown;
        int refused = 0;
        while (!machine.try_pass(budgets, Phase::Coarse))
            ASSERT_LE(++refused, 5) << grown;
        EXPECT_GE(refused, 1) << grown;
        // The quads that it was allowed meanwhile are taken back.
        for (int edit = 0; edit < 10; ++edit)
            EXPECT_LT(machine.pass(budgets, Phase::Coarse), 0.0036) << grown;
    }
}

TEST(PassBudgets, AllowsNeverMoreThanTheMostOfAPassHoweverOftenItIsRefused) {
    Machine machine{2e-6};
    PassBudgets budgets = settled(machine);
    const double before = budgets.separation(Phase::Coarse);
    for (int edit = 0; edit < 1000; ++edit)
        EXPECT_EQ(budgets.too_many(Phase::Coarse, 0.001), edit < 8) << edit;
    EXPECT_EQ(budgets.quads(Phase::Coarse), 6000U);
    EXPECT_LT(budgets.separation(Phase::Coarse), 30.0 * before);
    machine.pass(budgets, Phase::Coarse);
    EXPECT_TRUE(budgets.too_many(Phase::Coarse, 0.001)) << "counted anew after a pass that ended";
}

TEST(PassBudgets, RecoversStepByStepFromOneSlowPass) {
    Machine machine{2e-6};
    PassBudgets budgets = settled(machine);
    machine.seconds_a_quad *= 10.0; // somebody else had the processor
    machine.pass(budgets, Phase::Coarse);
    machine.seconds_a_quad /= 10.0;
    double before = 0.0;
    for (int edit = 0; edit < 6; ++edit) {
        const double seconds = machine.pass(budgets, Phase::Coarse);
        EXPECT_LT(seconds, 0.0036) << "never above its time on the way";
        EXPECT_GE(seconds, before * 0.99);
        before = seconds;
    }
    EXPECT_NEAR(before, 0.0035, 0.0005);
}

} // namespace wakesurf::server::pass_budgets_test
