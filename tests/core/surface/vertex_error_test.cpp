// The error a surface states for each vertex, against its particle traced again with a tolerance of 1e-12.
#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/surface_builder.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace wakesurf::core::vertex_error_test {

using namespace tests;

namespace {

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
    double worst = 0.0; ///< true error of all
    double most_stated = 0.0;
    std::vector<double> ratio; ///< estimate over true error

    double median() {
        std::nth_element(ratio.begin(),
                         ratio.begin() + static_cast<std::ptrdiff_t>(ratio.size() / 2),
                         ratio.end());
        return ratio.empty() ? 0.0 : ratio[ratio.size() / 2];
    }
};

double tolerance(Accuracy accuracy) {
    return accuracy == Accuracy::Fast ? 1e-4 : accuracy == Accuracy::Balanced ? 1e-5 : 1e-9;
}

void compare(const Flow& flow, const Rake& rake, const SurfaceParameters& p, Compared& sum) {
    const auto surface = build_surface(flow, rake, p);
    ASSERT_TRUE(surface) << surface.error().message;
    const QuadComplex& mesh = surface->mesh;
    ASSERT_EQ(mesh.error.size(), mesh.vertices());
    const SeedingCurve seeding(rake);
    std::vector<Curve> curves;
    std::vector<VertexId> of;
    const auto stride = static_cast<VertexId>(1 + mesh.vertices() / 300);
    for (VertexId v = 0; v < mesh.vertices(); v += stride) {
        if (mesh.t[v] == 0.0)
            continue;
        Curve& curve = curves.emplace_back();
        curve.seed = seeding.at(mesh.s[v]);
        curve.release = p.from;
        curve.duration = mesh.t[v];
        of.push_back(v);
    }
    if (curves.empty())
        return;
    TraceOptions tight;
    tight.frozen = p.kind == SurfaceKind::Stream;
    tight.tolerance = 1e-12;
    tight.longest_step = flow.finest_spacing();
    for (const double sign : {1.0, -1.0}) {
        std::vector<Curve> some;
        std::vector<VertexId> which;
        for (std::size_t i = 0; i < curves.size(); ++i)
            if (sign * curves[i].duration > 0.0) {
                some.push_back(curves[i]);
                which.push_back(of[i]);
            }
        if (some.empty())
            continue;
        ASSERT_TRUE(flow.trace(some, tight, {}));
        for (std::size_t i = 0; i < some.size(); ++i) {
            if (some[i].end != CurveEnd::Time)
                continue; // the last vertex of a curve that left: it ends a rounding earlier
            const double truth = glm::length(some[i].last.position - mesh.position[which[i]]);
            const double stated = mesh.error[which[i]];
            ++sum.vertices;
            sum.within += truth <= 3.0 * stated + tolerance(p.accuracy);
            sum.worst = std::max(sum.worst, truth);
            sum.most_stated = std::max(sum.most_stated, stated);
            if (truth > 1e-12)
                sum.ratio.push_back(stated / truth);
        }
    }
}

/// Random lines through the domain, and one through its middle, where bodies and axes are.
std::vector<Rake> rakes(const Box& box, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0.1, 0.9);
    const auto point = [&] {
        return box.lo + box.extent() * Vec3(part(random), part(random), part(random));
    };
    std::vector<Rake> all;
    for (int i = 0; i < 3; ++i)
        all.push_back({Rake::Kind::Line, {point(), point()}, 12});
    const Vec3 middle = box.lo + 0.5 * box.extent();
    const Vec3 reach = 0.08 * box.extent();
    all.push_back({Rake::Kind::Line,
                   {middle - reach * Vec3(3.0, 1.0, 0.3), middle - reach * Vec3(3.0, -1.0, 0.3)},
                   12});
    return all;
}

} // namespace

TEST(VertexError, IsAtLeastAThirdOfTheTrueErrorOfNearlyEveryVertexInEveryClosedForm) {
    for (const std::string& name : analytic_flow_names()) {
        const auto flow = *make_analytic_flow(name);
        Compared sum;
        for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path})
            for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced})
                for (const Rake& rake : rakes(flow->domain(), 7)) {
                    SurfaceParameters p;
                    p.kind = kind;
                    p.accuracy = accuracy;
                    p.to = 5.0;
                    p.max_quads = 20'000;
                    p.separation = 0.03 * glm::length(flow->domain().extent());
                    if (flow->status(rake.points[0]) == PointStatus::Inside)
                        compare(*flow, rake, p, sum);
                }
        EXPECT_GT(sum.vertices, 100u) << name;
        EXPECT_GE(static_cast<double>(sum.within), 0.99 * static_cast<double>(sum.vertices))
            << name;
    }
}

TEST(VertexError, ShowsWhatAStagnationLineMakesOfTheTolerance) {
    const auto flow = *make_analytic_flow("cylinder");
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path})
        for (const double y : {0.3, 0.03, 0.003}) {
            const Rake rake{Rake::Kind::Line, {{-2.5, -y, -0.5}, {-2.5, 1.3 * y, 0.6}}, 16};
            SurfaceParameters p;
            p.kind = kind;
            p.to = 8.0;
            p.separation = 0.1;
            Compared sum;
            compare(*flow, rake, p, sum);
            EXPECT_GE(static_cast<double>(sum.within), 0.99 * static_cast<double>(sum.vertices));
            // A hundred tolerances a length, and it says so.
            EXPECT_GT(sum.worst, 1e-3);
            EXPECT_GT(3.0 * sum.most_stated, sum.worst);
        }
}

TEST(VertexError, HoldsForStoredData) {
    const Box box{Vec3(-3), Vec3(3)};
    for (const char* name : {"abc", "lamb-oseen", "rotating-strain", "hill"}) {
        const auto flow = sampled(name, box);
        Compared sum;
        for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Path})
            for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced})
                for (const Rake& rake : rakes(box, 11)) {
                    SurfaceParameters p;
                    p.kind = kind;
                    p.accuracy = accuracy;
                    p.to = 4.0;
                    p.separation = 0.3;
                    p.max_quads = 20'000;
                    compare(*flow, rake, p, sum);
                }
        EXPECT_GT(sum.vertices, 100u) << name;
        EXPECT_GE(static_cast<double>(sum.within), 0.99 * static_cast<double>(sum.vertices))
            << name;
        // Neither far too small nor far too large.
        EXPECT_GT(sum.median(), 0.3) << name;
        EXPECT_LT(sum.median(), 20.0) << name;
    }
}

} // namespace wakesurf::core::vertex_error_test
