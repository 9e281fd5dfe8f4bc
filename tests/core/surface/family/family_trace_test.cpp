#include "core/field/analytic_flow.hpp"
#include "core/surface/family/family_trace.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace wakesurf::core::family_trace_test {
namespace {

constexpr double pi = std::numbers::pi;

UniformGrid nodes_over(const Box& box, std::uint32_t each) {
    return {box.lo, box.extent() / double(each - 1), {each, each, each}};
}

std::vector<Vec3> every_node(const Grid& grid) {
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < node_count(grid); ++i)
        out.push_back(node_position(grid, i));
    return out;
}

Result<FamilyField> carried(const Flow& flow, const Grid& grid, const FamilyRequest& request) {
    return plan_family(flow, request, 0.0, every_node(grid), {})
        .and_then([&](const FamilyPlan& plan) { return trace_family(flow, grid, plan, {}, {}); });
}

/// What a node should have; nothing: it should have none; NaN: it is not looked at.
using Expected = std::function<std::optional<double>(const Vec3&)>;

constexpr double not_looked_at = std::numeric_limits<double>::quiet_NaN();

/// Largest error at the nodes that should have a value.
double worst(const FamilyField& field, const Grid& grid, const Expected& expected) {
    double largest = 0.0;
    for (std::size_t i = 0; i < node_count(grid); ++i) {
        const Vec3 p = node_position(grid, i);
        const auto wanted = expected(p);
        if (wanted && std::isnan(*wanted))
            continue;
        EXPECT_EQ(std::isfinite(field.values[i]), wanted.has_value())
            << p.x << ' ' << p.y << ' ' << p.z;
        if (wanted)
            largest = std::max(largest, std::abs(field.values[i] - *wanted));
    }
    return largest;
}

struct Case {
    const char* flow;
    Box box; ///< of the nodes, within the flow's domain
    FamilyRequest request;
    Expected expected;
};

double back_to(double lo, double x, double speed) {
    return (x - lo) / speed;
}

std::vector<Case> closed_forms() {
    const Box ten{Vec3(-10), Vec3(10)};
    const double a2 = 0.25;
    return {
        {"uniform?u=1,v=0.5,w=0.25",
         ten,
         {FamilyInflow{}, "y"},
         [](const Vec3& p) {
             const double back = std::min(
                 {back_to(-10, p.x, 1.0), back_to(-10, p.y, 0.5), back_to(-10, p.z, 0.25)});
             return p.y - 0.5 * back;
         }},
        {"shear?u=1,g=0.1",
         Box{Vec3(-20, -20, -5), Vec3(20, 20, 20)},
         {FamilyPlane{{3, 0, 0}, {-1, 0, 0.5}}, "x"}, // upstream of it as well
         [](const Vec3& p) { return 3.0 + 0.5 * p.z; }},
        {"rotation?omega=1,w=0.2",
         Box{{-6, -6, -3}, {6, 6, 3}},
         {FamilyPlane{{0, 0, 0}, {0, 1, 0}}, "z"},
         [](const Vec3& p) -> std::optional<double> {
             const double turn = std::atan2(p.y, p.x);
             return std::hypot(p.x, p.y) == 0.0 ? not_looked_at
                                                : p.z - 0.2 * (turn < 0.0 ? turn + 2 * pi : turn);
         }},
        {"strain?a=0.5,b=-0.5,c=0",
         ten,
         {FamilyInflow{}, "x"},
         [](const Vec3& p) -> std::optional<double> {
             if (p.y == 0.0)
                 return std::nullopt;
             return p.x * std::abs(p.y) / 10.0;
         }},
        {"cylinder?u=1,a=0.5,w=0.2",
         Box{{-4, -3, -3}, {6, 3, 3}},
         {FamilyPlane{{-3, 0, 0}, {1, 0, 0}}, "y"},
         [a2](const Vec3& p) -> std::optional<double> {
             const double r2 = p.x * p.x + p.y * p.y;
             if (r2 < a2)
                 return std::nullopt;
             if (p.y == 0.0 || r2 < 1.1 * a2) // towards the stagnation point
                 return not_looked_at;
             const double stream = p.y * (1.0 - a2 / r2);
             double y = stream; // where the streamline passes the plane
             for (int i = 0; i < 60; ++i)
                 y = stream / (1.0 - a2 / (9.0 + y * y));
             return y;
         }},
    };
}

TEST(FamilyTrace, HasTheValuesOfTheClosedFormsAndTheirErrorFallsWithTheTolerance) {
    for (const Case& each : closed_forms()) {
        SCOPED_TRACE(each.flow);
        const auto flow = make_analytic_flow(each.flow).value();
        const Grid grid = nodes_over(each.box, 17);
        double before = 0.0;
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
            FamilyRequest request = each.request;
            request.accuracy = accuracy;
            const auto field = value_of(carried(*flow, grid, request));
            const double error = worst(field, grid, each.expected);
            if (accuracy == Accuracy::Balanced) {
                EXPECT_LE(error, std::max(0.3 * before, 1e-5));
            }
            if (accuracy == Accuracy::Exact) {
                EXPECT_LT(error, 5e-6); // a float of 10 has roundings of 5e-7
            }
            before = error;
            const FamilyCounts& n = field.counts;
            EXPECT_EQ(n.nodes, n.reached + n.at_rest + n.obstacle + n.lost + n.outside);
        }
    }
}

// Where the flow turns within the longest step, only error control keeps to the streamline.
TEST(FamilyTrace, IsAsExactRoundAVortexAsItIsAskedToBe) {
    const auto flow = make_analytic_flow("lamb-oseen?gamma=6.283185307179586,rc=0.3,w=0.5").value();
    const Grid grid = nodes_over({{-1, -1, -1}, {1, 1, 1}}, 12);
    const auto expected = [](const Vec3& p) {
        const double r2 = p.x * p.x + p.y * p.y;
        const double turn = std::atan2(p.y, p.x);
        const double angular = -std::expm1(-r2 / 0.09) / r2;
        return p.z - 0.5 * (turn < 0.0 ? turn + 2 * pi : turn) / angular;
    };
    std::vector<double> errors;
    for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
        const FamilyRequest request{FamilyPlane{{0, 0, 0}, {0, 1, 0}}, "z", accuracy};
        const auto field = value_of(carried(*flow, grid, request));
        errors.push_back(worst(field, grid, expected));
    }
    EXPECT_LT(errors[1], 0.5 * errors[0]);
    EXPECT_LT(errors[2], 0.2 * errors[1]);
    EXPECT_LT(errors[2], 1e-6);
}

TEST(FamilyTrace, HasNoValueWhereStreamlinesCloseAndCountsThem) {
    const auto flow = make_analytic_flow("rotation?omega=1,w=0").value();
    const Grid grid = nodes_over({Vec3(-10), Vec3(10)}, 15);
    FamilyRequest request{FamilyInflow{}, "z"};
    request.length = 100.0; // one and a half turns of the largest circle within the domain
    const auto field = value_of(carried(*flow, grid, request));
    std::uint64_t closed = 0;
    std::uint64_t still = 0;
    for (std::size_t i = 0; i < node_count(grid); ++i) {
        const Vec3 p = node_position(grid, i);
        const double r = std::hypot(p.x, p.y);
        still += r == 0.0 ? 1 : 0;
        closed += r > 0.0 && r < 9.999 ? 1 : 0;
        if (r < 9.999) {
            EXPECT_TRUE(std::isnan(field.values[i]));
        }
        if (r > 10.001) {
            EXPECT_NEAR(field.values[i], p.z, 1e-6);
        }
    }
    EXPECT_EQ(field.counts.at_rest, still);
    EXPECT_GE(field.counts.lost, closed);
}

} // namespace
} // namespace wakesurf::core::family_trace_test
