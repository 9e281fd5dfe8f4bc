#include "protocol/wire/lattice.hpp"
#include "tests/support/dequantise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace wakesurf::protocol::lattice_test {
namespace {

const core::Box box{{-1, 2, 0}, {6, 4, 1}};

TEST(Lattice, CoversTheDomainAndHalfAPercentMoreOnEachEndOfTheLongestSide) {
    const Lattice lattice = lattice_over(box);
    const core::Vec3 far =
        tests::dequantise(lattice, {lattice.last(), lattice.last(), lattice.last()});
    EXPECT_NEAR(lattice.origin.x, -1 - 0.035, 1e-12);
    EXPECT_NEAR(far.x, 6 + 0.035, 1e-12);
    EXPECT_NEAR(far.y - lattice.origin.y, 7 * 1.01, 1e-12);
    EXPECT_TRUE(LatticeRounding(lattice).holds(box.lo));
    EXPECT_TRUE(LatticeRounding(lattice).holds(box.hi));
}

TEST(Lattice, MovesAPointByAtMostHalfAStepAndANodeNotAtAll) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const int bits : {1, 8, 16, 20}) {
        const Lattice lattice = lattice_over(box, bits);
        for (int i = 0; i < 2000; ++i) {
            const core::Vec3 p =
                box.lo + box.extent() * core::Vec3(unit(random), unit(random), unit(random));
            ASSERT_TRUE(LatticeRounding(lattice).holds(p));
            const LatticePoint node = LatticeRounding(lattice).nearest(p);
            const core::Vec3 q = tests::dequantise(lattice, node);
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_LE(std::abs(p[axis] - q[axis]), 0.5 * lattice.step * (1 + 1e-9));
            ASSERT_EQ(LatticeRounding(lattice).nearest(q), node) << "bits " << bits;
        }
    }
}

TEST(Lattice, EndsHalfAStepBeyondItsOuterNodes) {
    const Lattice lattice{{0, 0, 0}, 1.0, 4};
    EXPECT_TRUE(LatticeRounding(lattice).holds({-0.5, 0, 15.4999}));
    EXPECT_FALSE(LatticeRounding(lattice).holds({-0.5001, 0, 0}));
    EXPECT_FALSE(LatticeRounding(lattice).holds({0, 0, 15.5}));
    // The largest number below 15.5 must not round to a node 16 on the way.
    const double below = std::nextafter(15.5, 0.0);
    EXPECT_TRUE(!LatticeRounding(lattice).holds({below, 0, 0}) ||
                LatticeRounding(lattice).nearest({below, 0, 0})[0] == 15);
}

TEST(Lattice, HasNoNodeForNumbersThatAreNotFinite) {
    const Lattice lattice = lattice_over(box);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity, 3.4e38, -3.4e38, 1e300})
        for (int axis = 0; axis < 3; ++axis) {
            core::Vec3 p = box.lo;
            p[axis] = bad;
            EXPECT_FALSE(LatticeRounding(lattice).holds(p)) << bad;
        }
}

TEST(Lattice, HoldsTheRepetitionsOfADomainWithNoLongerStep) {
    const Lattice once = lattice_over(box);
    EXPECT_EQ(lattice_over(box, core::PeriodicAxes{}), once);
    for (const core::PeriodicAxes& axes :
         {core::PeriodicAxes{true, false, false}, {false, true, true}, {true, true, true}}) {
        const Lattice lattice = lattice_over(box, axes);
        const core::Box all = core::repeated(box, axes);
        EXPECT_TRUE(valid(lattice));
        EXPECT_LE(lattice.step, once.step);
        EXPECT_TRUE(LatticeRounding(lattice).holds(all.lo));
        EXPECT_TRUE(LatticeRounding(lattice).holds(all.hi));
    }
}

TEST(Lattice, IsUsableOverADomainWithoutExtentAndRefusesNonsense) {
    EXPECT_TRUE(valid(lattice_over({{1, 1, 1}, {1, 1, 1}})));
    EXPECT_FALSE(valid({{0, 0, 0}, 0.0, 16}));
    EXPECT_FALSE(valid({{0, 0, 0}, 1.0, 21}));
    EXPECT_FALSE(valid({{0, std::numeric_limits<double>::quiet_NaN(), 0}, 1.0, 16}));
    EXPECT_FALSE(valid({{0, 0, 0}, std::numeric_limits<double>::infinity(), 16}));
}

} // namespace
} // namespace wakesurf::protocol::lattice_test
