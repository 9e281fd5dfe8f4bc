// Deformation that is not along the rake: a sheet sheared before it is pressed together, and strain from any
// side.
#include "core/field/bounded_form.hpp"
#include "core/field/closed_forms.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace wakesurf::core::oblique_strain_test {

namespace {

using namespace tests;

constexpr double most_slivers = 0.02;
constexpr double least_angle5 = 10.0;

template <class Form>
std::shared_ptr<const Flow> in_a_cube(const Form& form, double half) {
    return std::make_shared<AnalyticFlow<Form>>(form, Box{Vec3(-half), Vec3(half)});
}

/// Shear until the time 6, then over half a unit of time into strain that presses together along x.
struct ShearThenStrain {
    double shear, strain;
    double along_z; ///< part of the strain that goes there, the rest goes across the sheet

    Vec3 velocity(const Vec3& p, double t) const {
        const double part = std::clamp((t - 6.0) / 0.5, 0.0, 1.0);
        const double now = part * part * (3.0 - 2.0 * part);
        const Vec3 pressed(-p.x, (1.0 - along_z) * p.y, along_z * p.z);
        return (1.0 - now) * Vec3(1.0 + shear * p.z, 0.0, 0.0) + now * strain * pressed;
    }
};

/// Both axes of the sheet are pressed together.
struct ShearThenPress {
    double shear, strain;

    Vec3 velocity(const Vec3& p, double t) const {
        const double part = std::clamp((t - 6.0) / 0.5, 0.0, 1.0);
        const double now = part * part * (3.0 - 2.0 * part);
        return (1.0 - now) * Vec3(1.0 + shear * p.z, 0.0, 0.0) +
               now * strain * Vec3(-p.x, 2.0 * p.y, -p.z);
    }
};

/// Along x and y turned by an angle about z.
struct TurnedStrain {
    double strain, angle;

    Vec3 velocity(const Vec3& p, double) const {
        const double c = strain * std::cos(2.0 * angle), s = strain * std::sin(2.0 * angle);
        return {c * p.x + s * p.y, s * p.x - c * p.y, 0.0};
    }
};

/// After every step, while there are enough quads to have shares of.
void expect_well_shaped_all_the_way(const MovingRun& asked) {
    SCOPED_TRACE(asked.name);
    constexpr std::size_t least_quads = 150;
    MeshShape thinnest, most_slivers_of;
    thinnest.angle5 = 90.0;
    std::size_t looks = 0;
    follow(asked, 0, [&](const MovingSurface& surface, const KeyedMesh& shown) {
        const MeshShape shape = shape_of(surface, shown);
        if (shape.quads < least_quads)
            return;
        ++looks;
        if (shape.slivers > most_slivers_of.slivers)
            most_slivers_of = shape;
        if (shape.angle5 < thinnest.angle5)
            thinnest = shape;
    });
    EXPECT_GT(looks, 10u);
    EXPECT_LE(most_slivers_of.slivers, most_slivers) << most_slivers_of;
    EXPECT_GE(thinnest.angle5, least_angle5) << thinnest;
}

SurfaceParameters released_until(double release_until, SurfaceParameters p) {
    p.release_until = release_until;
    return p;
}

} // namespace

TEST(ObliqueStrain, ASheetThatWasShearedIsPressedTogetherWithoutSlivers) {
    const auto flow = in_a_cube(ShearThenStrain{1.0, 0.8, 1.0}, 20.0);
    const Rake rake = line_rake({-6, 0, -0.5}, {-6, 0, 1.0});
    expect_well_shaped_all_the_way({flow, rake, released_until(6.0, streak(8.5, 0.2)), "streak"});
    expect_well_shaped_all_the_way({flow, rake, swept({4.0, 0.0, 0.0}, 8.5, 0.2), "time"});
}

TEST(ObliqueStrain, ASheetThatWasShearedAndShrinksBothWaysIsJoinedWithoutSlivers) {
    const auto flow = in_a_cube(ShearThenPress{1.0, 0.5}, 20.0);
    const Rake rake = line_rake({-6, 0, -1.0}, {-6, 0, 2.0});
    expect_well_shaped_all_the_way({flow, rake, released_until(6.0, streak(9.0, 0.2)), "streak"});
    expect_well_shaped_all_the_way({flow, rake, swept({4.0, 0.0, 0.0}, 9.0, 0.2), "time"});
}

TEST(ObliqueStrain, StrainWhoseAxesTurnFasterThanItStrainsLeavesNoSlivers) {
    RotatingStrainFlow turning{0.5, 1.0, 0.3};
    const auto flow = in_a_cube(turning, 20.0);
    expect_well_shaped_all_the_way(
        {flow, line_rake({0.3, 0, -2}, {2, 0.4, -2}), streak(7, 0.12), "streak"});
    expect_well_shaped_all_the_way(
        {flow, line_rake({-1, -1, -2}, {1, -1, -2}), swept({0, 2, 0}, 7, 0.12), "time"});
}

TEST(ObliqueStrain, StrainFromAnySideMakesAsManyQuadsAsStrainAlongTheRake) {
    const auto quads_at = [](double degrees) {
        const auto flow = in_a_cube(TurnedStrain{0.5, degrees * std::numbers::pi / 180.0}, 20.0);
        const Rake rake = line_rake({-2.013, -2.007, 0}, {1.987, -2.007, 0});
        const MeshShape shape = final_shape({flow, rake, swept({0, 4, 0}, 1.6, 0.12), "time"});
        EXPECT_LE(shape.slivers, most_slivers) << degrees << " degrees: " << shape;
        EXPECT_GE(shape.angle5, least_angle5) << degrees << " degrees: " << shape;
        EXPECT_GE(shape.median, 45.0) << degrees << " degrees: " << shape;
        return static_cast<double>(shape.quads);
    };
    const double aligned = quads_at(0.0);
    EXPECT_GT(aligned, 1000.0);
    for (const double degrees : {15.0, 30.0, 45.0, 60.0, 90.0})
        EXPECT_NEAR(quads_at(degrees), aligned, 0.1 * aligned) << degrees << " degrees";
}

TEST(ObliqueStrain, PressesAPatchTogetherFromAnySideWithoutSlivers) {
    for (const double degrees : {0.0, 22.5, 45.0, 67.5}) {
        const auto flow = in_a_cube(TurnedStrain{0.5, degrees * std::numbers::pi / 180.0}, 20.0);
        const Rake rake = line_rake({-1.513, -1.507, 0}, {1.487, -1.507, 0});
        expect_well_shaped_all_the_way(
            {flow, rake, swept({0, 3, 0}, 3.0, 0.2), std::to_string(degrees) + " degrees"});
    }
}

} // namespace wakesurf::core::oblique_strain_test
