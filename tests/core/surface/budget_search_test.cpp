#include "core/surface/budget_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace wakesurf::core::budget_search_test {

namespace {

/// A surface whose number of quads is known for each separation.
using Law = std::function<double(double)>;

struct Found {
    double separation = 0.0; ///< 0: none
    double quads = 0.0;
    double cost = 0.0; ///< quads built in all, of the budget
};

Found search(
    const Law& law, double requested, double estimate, std::uint64_t most, double coarsest) {
    BudgetSearch search(requested, coarsest, estimate, most);
    Found out;
    for (int i = 0; i < 100; ++i) {
        const auto trial = search.next();
        if (!trial)
            return out;
        EXPECT_GE(trial->separation, requested);
        EXPECT_LE(trial->separation, std::max(requested, coarsest));
        EXPECT_LE(trial->most, most);
        const double quads = std::floor(law(trial->separation));
        out.cost += std::min(quads, static_cast<double>(trial->most)) / static_cast<double>(most);
        if (quads > static_cast<double>(trial->most)) {
            search.exceeded();
        } else if (search.built(static_cast<std::uint64_t>(quads))) {
            out.separation = trial->separation;
            out.quads = quads;
            return out;
        }
    }
    ADD_FAILURE() << "it does not end";
    return out;
}

} // namespace

TEST(BudgetSearch, TakesTheSeparationAskedForWhereItFits) {
    const Found found = search([](double s) { return 10.0 / (s * s); }, 0.1, 900.0, 5000, 10.0);
    EXPECT_EQ(found.separation, 0.1);
    EXPECT_LE(found.cost, 0.25); // 1,000 of 5,000 quads, and what the trials take
}

TEST(BudgetSearch, FillsMostOfTheBudgetForAboutTwiceItsCostWhateverThePowerLaw) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> power(1.0, 2.3), growth(0.0, 4.0), size(3.3, 6.0);
    for (int i = 0; i < 300; ++i) {
        const double p = power(random);
        const auto most = static_cast<std::uint64_t>(std::pow(10.0, size(random)));
        const double at_requested = static_cast<double>(most) * std::pow(10.0, growth(random));
        const auto law = [&](double s) { return at_requested * std::pow(s, -p); };
        const Found found = search(law, 1.0, at_requested / 3.0, most, 1e9);
        ASSERT_GT(found.separation, 0.0);
        if (found.separation > 1.0) {
            EXPECT_GE(found.quads, 0.7 * static_cast<double>(most)) << "power " << p;
        }
        EXPECT_LE(found.cost, 2.1) << "power " << p << ", " << at_requested << " of " << most;
    }
}

TEST(BudgetSearch, FindsItsWayWhereTheCountJumps) {
    // Columns double where the separation passes a power of two, as those of a sheet that diverges evenly.
    const auto law = [](double s) { return std::exp2(std::ceil(std::log2(1e3 / s))) * 100.0 / s; };
    const Found found = search(law, 0.01, 1e6, 20'000, 1e3);
    EXPECT_GE(found.quads, 0.5 * 20'000);
    EXPECT_LE(found.quads, 20'000);
}

TEST(BudgetSearch, EndsWhateverTheEstimateAndHoweverSteepTheCount) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> power(0.3, 30.0), ten(-4.0, 4.0), size(1.0, 6.0);
    for (int i = 0; i < 1000; ++i) {
        const double p = power(random);
        const auto most = static_cast<std::uint64_t>(std::pow(10.0, size(random)));
        const double at_requested = static_cast<double>(most) * std::pow(10.0, ten(random));
        const double estimate = at_requested * std::pow(10.0, ten(random));
        const auto law = [&](double s) { return at_requested * std::pow(s, -p); };
        const Found found = search(law, 1.0, estimate, most, std::pow(10.0, 1.0 + ten(random)));
        if (at_requested <= static_cast<double>(most)) {
            EXPECT_EQ(found.separation, 1.0);
        }
        EXPECT_LE(found.quads, static_cast<double>(most));
    }
}

TEST(BudgetSearch, EndsWithNothingWhereNotEvenTheCoarsestFits) {
    const Found found = search([](double) { return 300.0; }, 0.1, 300.0, 200, 2.0);
    EXPECT_EQ(found.separation, 0.0);
    EXPECT_LE(found.cost, 4.0);
}

TEST(BudgetSearch, NeverRaisesTheSeparationBeyondATenthOfTheDomain) {
    EXPECT_DOUBLE_EQ(coarsest_separation(Box{Vec3(-1, 0, 0), Vec3(3, 1, 20)}), 2.0);
}

} // namespace wakesurf::core::budget_search_test
