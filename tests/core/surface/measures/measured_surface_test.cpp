// Numbers of surfaces that formulas know: area, flux, ages on a plane, times of stay, tubes; and of which order they are.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/measures/numbers_over_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace wakesurf::core::measured_surface_test {

namespace {

constexpr double pi = std::numbers::pi;

struct Told {
    std::map<std::string, double> number;
    std::vector<std::string> notes;

    double operator[](const std::string& name) const {
        const auto found = number.find(name);
        EXPECT_NE(found, number.end()) << name;
        return found == number.end() ? not_known : found->second;
    }

    bool has(const std::string& name) const { return number.contains(name); }

    bool notes_say(const std::string& words) const {
        return std::ranges::any_of(
            notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
    }
};

Told told(const char* flow,
          const Rake& rake,
          SurfaceParameters p,
          const std::optional<Region>& through = {},
          std::optional<double> time = {},
          const std::vector<AveragedField>& fields = {}) {
    p.angle = 180.0;
    p.merge = 0.0;
    const std::shared_ptr<const Flow> there = *make_analytic_flow(flow);
    const std::vector<double> times{time.value_or(p.to)};
    const auto table =
        numbers_over_time(*plan_surface(there, rake, p), times, through, fields, SteadyClock{}, {});
    EXPECT_TRUE(table) << table.error().message;
    Told out;
    for (std::size_t i = 0; i < table->columns.size(); ++i)
        out.number[table->columns[i].name] = table->rows.front()[i];
    out.notes = table->notes.front();
    return out;
}

const Rake radial{Rake::Kind::Line, {{0.5, 0, 0}, {2, 0, 0}}, 4};
const Rake upright{Rake::Kind::Line, {{0, 0, 0}, {0, 0, 1}}, 4};

Rake ring(const Vec3& centre, double radius) {
    return {
        Rake::Kind::Circle, {centre, centre + Vec3(radius, 0, 0), centre + Vec3(0, radius, 0)}, 12};
}

/// The area of the helicoid that a radial rake winds in `rotation?w=0.3` in the time t.
double helicoid(double t) {
    const auto integral = [](double r) {
        const double w = 0.3, root = std::hypot(r, w);
        return 0.5 * (r * root + w * w * std::log(r + root));
    };
    return t * (integral(2.0) - integral(0.5));
}

/// A field of places alone.
template <class Function>
AveragedField field_of(const std::string& name, const Function& function) {
    return {name, "K",
            [function](const QuadComplex& mesh, const std::vector<double>& times,
                       const std::stop_token&) -> Result<std::vector<float>> {
                EXPECT_EQ(times.size(), mesh.vertices());
                std::vector<float> out;
                for (const Vec3& p : mesh.position)
                    out.push_back(static_cast<float>(function(p)));
                return out;
            }};
}

} // namespace

TEST(MeasuredSurface, TheMeanOfAFieldIsByArea) {
    // An annulus from 0.5 to 2: the mean of r is 2/3 (2^3 - 0.5^3) / (2^2 - 0.5^2), of its half with x > 0 the same.
    const auto radius = [](const Vec3& p) { return std::hypot(p.x, p.y); };
    const Told found =
        told("rotation?w=0", radial, {.to = 2.0 * pi, .separation = 0.05},
             Region(Box{{0.0, -3.0, -1.0}, {3.0, 3.0, 1.0}}), {},
             {field_of("radius", radius), field_of("x", [](const Vec3& p) { return p.x; })});
    EXPECT_NEAR(found["mean_radius"], 1.4, 1e-3);
    EXPECT_NEAR(found["inside_mean_radius"], 1.4, 1e-3);
    EXPECT_NEAR(found["mean_x"], 0.0, 1e-3);
    EXPECT_NEAR(found["inside_mean_x"], 1.4 * 2.0 / pi, 2e-3);
}

TEST(MeasuredSurface, TheMeanOfAFieldWithGapsSaysOnHowMuchItIsKnown) {
    const auto half = [](const Vec3& p) { return p.y > 0.0 ? 3.0 : not_known; };
    const Told found = told("rotation?w=0", radial, {.to = 2.0 * pi, .separation = 0.05}, {}, {},
                            {field_of("half", half)});
    EXPECT_NEAR(found["mean_half"], 3.0, 1e-6);
    EXPECT_TRUE(found.notes_say("half is known on 49 % of the area") ||
                found.notes_say("half is known on 50 % of the area"));
    const Told none = told("rotation?w=0", radial, {.to = 1.0, .separation = 0.1}, {}, {},
                           {field_of("none", [](const Vec3&) { return not_known; })});
    EXPECT_TRUE(std::isnan(none["mean_none"]));
    EXPECT_TRUE(none.notes_say("none is known on 0 % of the area"));
}

TEST(MeasuredSurface, AreaIsOfFourthOrder) {
    std::vector<double> off;
    for (const double separation : {0.2, 0.1})
        off.push_back(std::abs(
            told("rotation?w=0.3", radial,
                 {.to = 3.0, .separation = separation, .accuracy = Accuracy::Exact})["area"] -
            helicoid(3.0)));
    EXPECT_GE(std::log2(off[0] / off[1]), 3.5);
    EXPECT_LT(off[1], 1e-5 * helicoid(3.0));
}

TEST(MeasuredSurface, IsMeasuredUpToAnAgeExactly) {
    for (const double age : {0.77, 1.9})
        EXPECT_NEAR(told("rotation?w=0.3", radial, {.to = 3.0, .separation = 0.1}, {}, age)["area"],
                    helicoid(age), 1e-4);
}

TEST(MeasuredSurface, AreaIsWithinItsStatedError) {
    for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact})
        for (const double separation : {0.4, 0.2, 0.1}) {
            const Told found = told("rotation?w=0.3", radial,
                                    {.to = 3.0, .separation = separation, .accuracy = accuracy});
            EXPECT_LT(std::abs(found["area"] - helicoid(3.0)), found["area_error"]);
            EXPECT_LT(found["area_error"], 0.05 * helicoid(3.0));
        }
}

TEST(MeasuredSurface, WhatParticlesFormIsNotPassedThrough) {
    const Told found = told("abc", radial, {.to = 1.0, .separation = 0.05});
    EXPECT_LE(std::abs(found["flux"]), found["flux_error"]);
    EXPECT_LT(found["flux_error"], 1e-2 * found["area"]);
}

TEST(MeasuredSurface, FluxThroughATimeSurfaceIsThatOfThePlaneItLiesIn) {
    // In shear?u=1,g=1 a patch of the plane z = 0 to 1 at x = 0 tilts to x = t (1 + z): u + g z passes over its width 1.
    const Told found =
        told("shear", upright,
             {.kind = SurfaceKind::Time, .to = 0.7, .separation = 0.1, .sweep = Vec3(0, 1, 0)});
    EXPECT_NEAR(std::abs(found["flux"]), 1.5, 1e-6);
    EXPECT_NEAR(found["area"], std::hypot(1.0, 0.7), 1e-6);
}

TEST(MeasuredSurface, AgesOnAPlaneAreThoseOfTheFlow) {
    // Particles at height z come to x = 1 at the age 1 / (1 + z).
    const Told found =
        told("shear", upright, {.to = 2.0, .separation = 0.05, .accuracy = Accuracy::Exact},
             Plane{{1, 0, 0}, {1, 0, 0}});
    EXPECT_NEAR(found["cut_length"], 1.0, 1e-6);
    EXPECT_NEAR(found["age_least"], 0.5, 1e-3);
    EXPECT_NEAR(found["age_median"], 1.0 / 1.5, 0.02);
    EXPECT_NEAR(found["age_p90"], 1.0 / 1.1, 0.02);
    EXPECT_TRUE(std::isnan(found["section_flux"]));
    EXPECT_TRUE(found.notes_say("not a whole circle"));
}

TEST(MeasuredSurface, APlaneThatIsNotMetHasNoAges) {
    const Told found =
        told("shear", upright, {.to = 2.0, .separation = 0.1}, Plane{{-0.5, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(found["cut_length"], 0.0);
    EXPECT_TRUE(std::isnan(found["age_median"]));
    EXPECT_TRUE(std::isnan(found["age_error"]));
    EXPECT_TRUE(found.notes_say("does not meet the plane"));
}

TEST(MeasuredSurface, ParticlesStayInABoxAsLongAsTheFlowTakes) {
    const Told found =
        told("shear", upright, {.to = 2.5, .separation = 0.05, .accuracy = Accuracy::Exact},
             Box{{0.5, -1, -1}, {1.5, 1, 2}});
    EXPECT_NEAR(found["residence_mean"], std::log(2.0), 1e-3);
    EXPECT_NEAR(found["residence_median"], 1.0 / 1.5, 1e-3);
    EXPECT_NEAR(found["residence_p90"], 1.0 / 1.1, 1e-2);
    EXPECT_EQ(found["entered"], 1.0);
    EXPECT_EQ(found["still_inside"], 0.0);
    EXPECT_NEAR(found["inside_area"], 1.0, 1e-6);
    EXPECT_NEAR(found["age_least"], 0.25, 1e-3); // where they come in, not where they leave
    const Told half =
        told("shear", upright, {.to = 2.5, .separation = 0.05}, Box{{0.5, -1, 0.5}, {9, 1, 2}});
    EXPECT_NEAR(half["entered"], 0.5, 1e-3);
    EXPECT_EQ(half["still_inside"], 1.0);
}

TEST(MeasuredSurface, ATubeInAFlowWithoutDivergenceKeepsItsFlux) {
    const Told found = told("lamb-oseen?w=0.5", ring({0, 0, -0.5}, 0.6),
                            {.to = 1.5, .separation = 0.05, .accuracy = Accuracy::Exact},
                            Plane{{0, 0, 0}, {0, 0, -1}});
    const double flux = 0.5 * pi * 0.36;
    EXPECT_NEAR(found["area"], 2.0 * pi * 0.6 * 0.75, found["area_error"]);
    EXPECT_NEAR(found["tube_flux"], flux, 1e-4);
    EXPECT_NEAR(found["tube_flux_at_rake"], flux, 1e-4);
    EXPECT_NEAR(found["section_flux"], -flux, 1e-4); // against the normal
    EXPECT_LT(std::abs(found["tube_flux_lost_by_tracing"]), 1e-5);
    EXPECT_LT(std::abs(found["tube_flux_gained_by_divergence"]), 1e-4);
    EXPECT_LE(std::abs(found["tube_flux"] - flux), found["tube_flux_error"]);
    EXPECT_LT(found["tube_flux_error"], 0.01 * flux);
}

TEST(MeasuredSurface, ATubeGainsWhatTheFlowDiverges) {
    for (const double to : {0.6, -0.6})
        for (const double up : {1.0, -1.0}) { // the ring turns either way
            const Rake rake{Rake::Kind::Circle, {{0, 0, 1}, {0.2, 0, 1}, {0, 0.2 * up, 1}}, 12};
            const Told found = told("strain?a=0.3,b=0.3,c=0.5", rake,
                                    {.to = to, .separation = 0.04, .accuracy = Accuracy::Exact});
            const double begin = 0.5 * pi * 0.04, end = begin * std::exp(1.1 * to);
            EXPECT_NEAR(found["tube_flux_at_rake"], begin, 1e-5);
            EXPECT_NEAR(found["tube_flux"], end, 1e-5);
            EXPECT_LT(std::abs(found["tube_flux_lost_by_tracing"]), 1e-3 * std::abs(end - begin));
            EXPECT_NEAR(found["tube_flux_gained_by_divergence"], end - begin, 2e-5);
        }
}

TEST(MeasuredSurface, ATubeThatLeavesTheDataHasNoFluxAndSaysWhy) {
    const Told found = told("uniform", ring({0, 0, 0}, 0.3), {.to = 50.0, .separation = 0.1});
    EXPECT_TRUE(std::isnan(found["tube_flux"]));
    EXPECT_TRUE(found.notes_say("form no closed curve, as some have ended"));
}

TEST(MeasuredSurface, NoErrorBetweenStoredTimesIsNotTakenForNone) {
    const Told found = told("rotation", radial, {.to = 1.0, .separation = 0.1});
    EXPECT_TRUE(std::isnan(found["area_interval_error"]));
    EXPECT_TRUE(std::isnan(found["unresolved"]));
    EXPECT_TRUE(found.notes_say("no error between stored times"));
}

TEST(MeasuredSurface, HasTheSameColumnsAtEveryTime) {
    for (const SurfaceKind kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const std::optional<Region>& through :
             {std::optional<Region>(), std::optional<Region>(Plane{{0.3, 0, 0}, {1, 0, 0}}),
              std::optional<Region>(Box{{0.1, -1, -1}, {0.6, 1, 0.5}})}) {
            SurfaceParameters p{.kind = kind, .to = 1.0, .separation = 0.1};
            if (kind == SurfaceKind::Time)
                p.sweep = Vec3(0, 0.5, 0);
            std::vector<std::vector<std::string>> names;
            for (const double time : {0.0, 0.3, 1.0}) {
                names.emplace_back();
                for (const auto& [name, value] : told("shear", upright, p, through, time).number)
                    names.back().push_back(name);
            }
            EXPECT_EQ(names[0], names[1]);
            EXPECT_EQ(names[1], names[2]);
        }
}

TEST(ErrorSpread, IsWhatMovingEveryVertexOfACylinderOutwardsChanges) {
    const std::shared_ptr<const Flow> flow = *make_analytic_flow("uniform?u=0,w=1");
    auto plan = *plan_surface(flow, ring({0, 0, 0}, 0.5), {.to = 0.8, .separation = 0.02});
    const Surface tube = *build_surface(plan);
    const auto spreader =
        *ErrorSpreader::of(plan, tube.mesh, vertex_times(tube, plan.parameters), {});
    const double off = 1e-3;
    const ErrorSpread found =
        spreader.spread(tube.mesh, {}, std::vector<double>(tube.mesh.vertices(), off));
    const double sides = 2.0 * pi * 0.8 * off, borders = 2.0 * 2.0 * pi * 0.5 * off;
    EXPECT_NEAR(found.area, sides + borders, 0.03 * (sides + borders));
    // Both rings let through 2 pi r off more.
    EXPECT_NEAR(found.flux, borders, 0.01 * borders);
    EXPECT_EQ(found.left_out, 0.0);
}

} // namespace wakesurf::core::measured_surface_test
