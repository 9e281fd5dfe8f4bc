// The error a streak or time surface states for each vertex, against its particle traced again with a tolerance of 1e-12.
#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/moving/origin.hpp"
#include "core/surface/moving/surface_history.hpp"
#include "core/surface/surface_builder.hpp"
#include "core/surface/surface_request.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>

namespace wakesurf::core::moving_error_test {

using namespace tests;

namespace {

const SteadyClock steady_clock;

std::unique_ptr<Flow> sampled(const char* name, Box box) {
    const std::shared_ptr<const Flow> form = *make_analytic_flow(name);
    UniformGrid grid;
    grid.dimensions = {41, 33, 37};
    grid.origin = box.lo;
    grid.spacing = box.extent() / Vec3(40, 32, 36);
    auto source = std::make_shared<SampledSource>(
        grid, std::vector<double>{0.0, 0.7, 1.1, 2.0, 3.5, 5.0}, [form](const Vec3& p, double t) {
            Vec3 v;
            EXPECT_TRUE(form->sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
            return v;
        });
    return make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
}

struct Compared {
    std::size_t vertices = 0, within = 0;
    std::vector<double> ratio; ///< estimate over true error, where that is above the tolerance

    double share() const { return static_cast<double>(within) / static_cast<double>(vertices); }

    double median() {
        if (ratio.empty())
            return 0.0;
        const auto middle = ratio.begin() + static_cast<std::ptrdiff_t>(ratio.size() / 2);
        std::nth_element(ratio.begin(), middle, ratio.end());
        return *middle;
    }

    void add(const Compared& other) {
        vertices += other.vertices;
        within += other.within;
        ratio.insert(ratio.end(), other.ratio.begin(), other.ratio.end());
    }
};

Compared compared(const Flow& flow, const Rake& rake, const SurfaceParameters& p) {
    Compared sum;
    const auto surface = build_surface(flow, rake, p);
    if (!surface) {
        ADD_FAILURE() << surface.error().message;
        return sum;
    }
    const QuadComplex& mesh = surface->mesh;
    EXPECT_EQ(mesh.error.size(), mesh.vertices());
    EXPECT_EQ(surface->statistics.error99.has_value(), !mesh.error.empty());
    const Origin origin =
        p.kind == SurfaceKind::Streak ? Origin(rake) : Origin(rake, *p.sweep, p.from);
    std::vector<Vec3> position;
    std::vector<double> time;
    std::vector<VertexId> of;
    const auto stride = static_cast<VertexId>(1 + mesh.vertices() / 100);
    for (VertexId v = 0; v < mesh.vertices(); v += stride) {
        of.push_back(v);
        position.push_back(origin.position(mesh.s[v], mesh.t[v]));
        time.push_back(origin.release(mesh.t[v]));
    }
    std::vector<CurveEnd> end(of.size(), CurveEnd::Running);
    AdvanceOptions tight;
    tight.method = AdvanceOptions::Method::Dopri5;
    tight.tolerance = 1e-12;
    tight.longest_step = flow.finest_spacing();
    EXPECT_TRUE(flow.advance({position, {}, {}, time, end}, p.to, tight, {}));
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (end[i] != CurveEnd::Running)
            continue; // it left by less than its error
        const double truth = glm::length(position[i] - mesh.position[of[i]]);
        const double stated = mesh.error[of[i]];
        const double tolerance = trace_tolerance(p.accuracy);
        ++sum.vertices;
        sum.within += truth <= 3.0 * stated + tolerance;
        if (truth > tolerance)
            sum.ratio.push_back(stated / truth);
    }
    return sum;
}

/// Random lines through the domain, and one through its middle, where bodies and axes are.
std::vector<Rake> rakes(const Box& box, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0.1, 0.9);
    const auto point = [&] {
        const double x = part(random), y = part(random), z = part(random);
        return box.lo + box.extent() * Vec3(x, y, z);
    };
    std::vector<Rake> all;
    for (int i = 0; i < 2; ++i) {
        const Vec3 from = point();
        all.push_back({Rake::Kind::Line, {from, point()}, 12});
    }
    const Vec3 middle = box.lo + 0.5 * box.extent();
    const Vec3 reach = 0.08 * box.extent();
    all.push_back({Rake::Kind::Line,
                   {middle - reach * Vec3(3.0, 1.0, 0.3), middle - reach * Vec3(3.0, -1.0, 0.3)},
                   12});
    return all;
}

SurfaceParameters
request(SurfaceKind kind, Accuracy accuracy, double to, double separation, const Vec3& sweep) {
    SurfaceParameters p;
    p.kind = kind;
    p.accuracy = accuracy;
    p.to = to;
    p.max_quads = 20'000;
    p.separation = separation;
    if (kind == SurfaceKind::Time)
        p.sweep = sweep;
    return p;
}

constexpr SurfaceKind kinds[] = {SurfaceKind::Streak, SurfaceKind::Time};

/// Surfaces of a flow from random rakes, at one accuracy.
Compared in_flow(const Flow& flow, Accuracy accuracy, double span, double part_of_domain) {
    Compared sum;
    const Vec3 extent = flow.domain().extent();
    for (const SurfaceKind kind : kinds) {
        Compared of_kind;
        for (const Rake& rake : rakes(flow.domain(), 7))
            if (flow.status(rake.points[0]) == PointStatus::Inside)
                of_kind.add(
                    compared(flow, rake,
                             request(kind, accuracy, kind == SurfaceKind::Time ? 0.3 * span : span,
                                     part_of_domain * glm::length(extent),
                                     0.08 * extent * Vec3(1.0, -0.5, 0.7))));
        EXPECT_GT(of_kind.vertices, 50u);
        sum.add(of_kind);
    }
    return sum;
}

} // namespace

TEST(MovingError, IsAtLeastAThirdOfTheTrueErrorOfNearlyEveryVertexInEveryClosedForm) {
    for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
        Compared all;
        for (const std::string& name : analytic_flow_names()) {
            SCOPED_TRACE(name);
            const auto flow = *make_analytic_flow(name);
            const bool exact = accuracy == Accuracy::Exact;
            const Compared sum = in_flow(*flow, accuracy, exact ? 3.0 : 5.0, exact ? 0.05 : 0.03);
            EXPECT_GE(sum.share(), 0.99)
                << static_cast<int>(accuracy) << ": " << sum.within << " of " << sum.vertices;
            all.add(sum);
        }
        // Neither far too small nor far too large.
        if (accuracy != Accuracy::Exact) {
            EXPECT_GT(all.ratio.size(), 200u);
            EXPECT_GT(all.median(), 1.0);
            EXPECT_LT(all.median(), 30.0);
        }
    }
}

TEST(MovingError, ShowsWhatAStagnationLineMakesOfTheTolerance) {
    for (const char* name : {"cylinder", "sphere"})
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced}) {
            const auto flow = *make_analytic_flow(name);
            Compared sum;
            for (const SurfaceKind kind : kinds)
                for (const double y : {0.3, 0.05}) {
                    const Rake rake{Rake::Kind::Line, {{-2.5, -y, -0.5}, {-2.5, 1.3 * y, 0.6}}, 16};
                    sum.add(compared(*flow, rake,
                                     request(kind, accuracy, kind == SurfaceKind::Time ? 4.5 : 6.0,
                                             0.15, Vec3(0.5, 0.0, 0.0))));
                }
            EXPECT_GE(sum.share(), 0.99) << name << ": " << sum.within << " of " << sum.vertices;
            EXPECT_GT(sum.median(), 1.0) << name;
            EXPECT_LT(sum.median(), 30.0) << name;
        }
}

TEST(MovingError, HoldsForStoredData) {
    const Box box{Vec3(-3), Vec3(3)};
    for (const char* name : {"abc", "lamb-oseen", "rotating-strain", "hill"}) {
        SCOPED_TRACE(name);
        const auto flow = sampled(name, box);
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
            Compared sum = in_flow(*flow, accuracy, 3.4, accuracy == Accuracy::Exact ? 0.05 : 0.02);
            EXPECT_GE(sum.share(), 0.99)
                << static_cast<int>(accuracy) << ": " << sum.within << " of " << sum.vertices;
            if (accuracy != Accuracy::Exact) {
                EXPECT_GT(sum.median(), 1.0);
                EXPECT_LT(sum.median(), 30.0);
            }
        }
    }
}

TEST(MovingError, IsTheSameForAnyNumberOfThreadsAndAfterGoingBack) {
    const auto flow = *make_analytic_flow("double-gyre");
    const Rake rake{Rake::Kind::Line, {{0.2, 0.5, 0.0}, {1.8, 0.5, 0.0}}, 8};
    for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced}) {
        const auto errors = [&](std::size_t threads, std::vector<double> looked_at) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const SurfaceParameters p = request(SurfaceKind::Streak, accuracy, 4.0, 0.1, Vec3(0.0));
            SurfaceHistory history(*MovingSurface::start(*flow, rake, p, {}, steady_clock), 1e6);
            for (const double time : looked_at)
                EXPECT_TRUE(history.at(time, {}));
            const auto shown = history.at(3.1, {});
            EXPECT_TRUE(shown);
            return shown->mesh.error;
        };
        const std::vector<float> once = errors(1, {});
        ASSERT_GT(once.size(), 100u);
        EXPECT_GT(*std::max_element(once.begin(), once.end()), 0.0f);
        EXPECT_EQ(errors(2, {}), once);
        EXPECT_EQ(errors(2, {3.9, 1.3, 4.0, 0.2}), once);
    }
}

} // namespace wakesurf::core::moving_error_test
