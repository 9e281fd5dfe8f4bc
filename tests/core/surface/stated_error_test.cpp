// The error that a surface states, against its distance from the exact surface, for every kind and accuracy.
#include "core/field/analytic_flow.hpp"
#include "tests/support/measured_error.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <random>

namespace wakesurf::core::stated_error_test {

using namespace tests;

namespace {

constexpr Accuracy accuracies[] = {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact};

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

/// Flow round a cylinder that sways, on a mesh of cells.
std::unique_ptr<Flow> meshed_cylinder() {
    CellMesh mesh = block({30, 60, 6}, round_cylinder, true);
    mark_walls(mesh, [](const Vec3& c) { return std::hypot(c.x, c.y) < 0.51; });
    return meshed_flow(std::move(mesh), {0.0, 2.0, 4.0, 6.0}, [](const Vec3& p, double t) {
        const double r2 = std::max(0.25, p.x * p.x + p.y * p.y);
        const double part = 0.25 / (r2 * r2);
        return Vec3(1.0 - part * (p.x * p.x - p.y * p.y),
                    -2.0 * part * p.x * p.y + 0.1 * std::sin(t), 0.0);
    });
}

/// Random lines through the domain, and perhaps one to its middle, where bodies and axes are. What fast surfaces interpolate where such a line
/// meets a body's stagnation line is up to twice as far off as they state.
std::vector<Rake> rakes(const Flow& flow, std::uint32_t seed, bool to_middle = true) {
    const Box box = flow.domain();
    std::mt19937 random(seed);
    const auto part = [&] {
        return 0.1 + 0.8 * static_cast<double>(random()) / std::mt19937::max();
    };
    const auto point = [&] {
        const double x = part(), y = part();
        return box.lo + box.extent() * Vec3(x, y, part());
    };
    const Vec3 middle = box.lo + 0.5 * box.extent();
    const Vec3 reach = 0.08 * box.extent();
    std::vector<Rake> all{
        {Rake::Kind::Line,
         {middle - reach * Vec3(3.0, 1.0, 0.3), middle - reach * Vec3(3.0, -1.0, 0.3)},
         12}};
    if (!to_middle)
        all.clear();
    for (int i = 0; i < 2; ++i) {
        const Vec3 from = point();
        all.push_back({Rake::Kind::Line, {from, point()}, 12});
    }
    std::erase_if(
        all, [&](const Rake& rake) { return flow.status(rake.points[0]) != PointStatus::Inside; });
    return all;
}

SurfaceParameters asked(const Flow& flow, SurfaceKind kind, Accuracy accuracy, double to) {
    const Vec3 extent = flow.domain().extent();
    SurfaceParameters p;
    p.kind = kind;
    p.accuracy = accuracy;
    p.to = kind == SurfaceKind::Time ? 0.3 * to : to;
    p.max_quads = 20'000;
    p.separation = (accuracy == Accuracy::Exact ? 0.05 : 0.03) * glm::length(extent);
    if (kind == SurfaceKind::Time)
        p.sweep = 0.08 * extent * Vec3(1.0, -0.5, 0.7);
    return p;
}

/// Surfaces of every kind and accuracy, from random rakes.
void expect_true_errors(const Flow& flow,
                        double to,
                        std::uint32_t seed,
                        std::size_t most,
                        double most_uncertain = 0.02) {
    for (const auto& [kind, name] : every_kind)
        for (const Accuracy accuracy : accuracies) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(static_cast<int>(accuracy)));
            // Beside a body of a closed form, which reaches to the wall itself, what fast states is rough, either way.
            if (accuracy == Accuracy::Fast && flow.obstacle() && !flow.time_range())
                continue;
            const SurfaceParameters p = asked(flow, kind, accuracy, to);
            MeasuredErrors sum;
            for (const Rake& rake :
                 rakes(flow, seed, !flow.obstacle() || accuracy != Accuracy::Fast))
                measure(sum, flow, rake, p, most);
            EXPECT_GT(sum.truth.size(), 20u);
            sum.check(accuracy, p.separation, 3.0 * glm::length(flow.domain().extent()));
            EXPECT_LE(static_cast<double>(sum.uncertain),
                      most_uncertain * static_cast<double>(sum.vertices));
        }
}

} // namespace

TEST(StatedError, HoldsFromBothSidesInEveryClosedForm) {
    for (const std::string& name : analytic_flow_names()) {
        // The tornado's velocity jumps: no place there has an exact particle to compare with.
        if (name == "tornado")
            continue;
        SCOPED_TRACE(name);
        expect_true_errors(**make_analytic_flow(name), 3.0, 7, 40, 0.02);
    }
}

TEST(StatedError, HoldsFromBothSidesForStoredDataWhateverTheSeed) {
    const Box box{Vec3(-3), Vec3(3)};
    std::uint32_t seed = 11;
    for (const char* name : {"lamb-oseen", "abc", "rotating-strain", "hill"}) {
        const auto flow = sampled(name, box);
        for (int i = 0; i < 2; ++i, ++seed) {
            SCOPED_TRACE(name + (" " + std::to_string(seed)));
            expect_true_errors(*flow, 3.0, seed, 40);
        }
    }
}

TEST(StatedError, HoldsFromBothSidesOnAMeshOfCellsWithABody) {
    expect_true_errors(*meshed_cylinder(), 6.0, 5, 80);
}

TEST(StatedError, OfCurvesThroughStoredDataHoldsForEverySeed) {
    const Box box{Vec3(-3), Vec3(3)};
    const auto flow = sampled("lamb-oseen", box);
    for (std::uint32_t seed = 11; seed < 23; ++seed)
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced}) {
            SCOPED_TRACE(seed);
            const SurfaceParameters p = asked(*flow, SurfaceKind::Path, accuracy, 4.0);
            MeasuredErrors sum;
            for (const Rake& rake : rakes(*flow, seed))
                measure(sum, *flow, rake, p, 100);
            sum.check(accuracy, p.separation, 3.0 * glm::length(flow->domain().extent()));
        }
}

TEST(StatedError, PastAStagnationLineIsThatOfTheSheetNotOfWhatSlidesAlongIt) {
    for (const char* name : {"cylinder", "sphere"}) {
        const auto flow = *make_analytic_flow(name);
        for (const auto& [kind, kind_name] : every_kind)
            for (const double y : {0.3, 0.003}) {
                SCOPED_TRACE(std::string(name) + " " + kind_name + " " + std::to_string(y));
                const Rake rake{Rake::Kind::Line, {{-2.5, -y, -0.5}, {-2.5, 1.3 * y, 0.6}}, 16};
                SurfaceParameters p;
                p.kind = kind;
                p.to = kind == SurfaceKind::Time ? 4.5 : 6.0;
                p.separation = 0.15;
                if (kind == SurfaceKind::Time)
                    p.sweep = Vec3(0.5, 0.0, 0.0);
                MeasuredErrors sum;
                measure(sum, *flow, rake, p, 200);
                sum.check(p.accuracy, p.separation, 3.0 * glm::length(flow->domain().extent()));
                EXPECT_LE(static_cast<double>(sum.uncertain),
                          0.01 * static_cast<double>(sum.vertices));
            }
    }
}

TEST(StatedError, CountsVerticesThatMayBeFartherThanTheSeparationApart) {
    QuadComplex mesh;
    EXPECT_FALSE(stated_error(mesh, 1.0));
    for (int i = 0; i < 1000; ++i)
        mesh.error.push_back(static_cast<float>(i + 1) / 1024.0f);
    EXPECT_EQ(stated_error(mesh, 2.0), (StatedError{991.0 / 1024.0, 0}));
    mesh.error[3] = std::numeric_limits<float>::quiet_NaN();
    mesh.error[5] = 1e30f;
    EXPECT_EQ(stated_error(mesh, 2.0), (StatedError{991.0 / 1024.0, 2}));
    EXPECT_EQ(stated_error(mesh, 1e-4), (StatedError{0.0, 1000}));
}

} // namespace wakesurf::core::stated_error_test
