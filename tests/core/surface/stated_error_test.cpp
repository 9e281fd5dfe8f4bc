// The error that a surface states, against its distance from the exact surface, for every kind and accuracy.
#include "core/field/analytic_flow.hpp"
#include "tests/support/meshed_field.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/true_errors.hpp"

namespace wakesurf::core::stated_error_test {

using namespace tests;

namespace {

std::unique_ptr<Flow> sampled(const char* name, Box box) {
    const std::shared_ptr<const Flow> form = *make_analytic_flow(name);
    UniformGrid grid{
        .origin = box.lo, .spacing = box.extent() / Vec3(40, 32, 36), .dimensions = {41, 33, 37}};
    auto source = std::make_shared<SampledSource>(
        grid, std::vector<double>{0.0, 0.7, 1.1, 2.0, 3.5, 5.0}, [form](const Vec3& p, double t) {
            Vec3 v;
            EXPECT_TRUE(form->sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
            return v;
        });
    return make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
}

/// A swirl that expands and contracts, stored so finely that its steps make most of the error.
std::unique_ptr<Flow> expanding(double rate) {
    std::vector<double> times(31);
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = 0.1 * static_cast<double>(i);
    const UniformGrid grid{.origin = Vec3(-8), .spacing = Vec3(0.5), .dimensions = {33, 33, 33}};
    auto source = std::make_shared<SampledSource>(grid, times, [rate](const Vec3& p, double t) {
        return (1.0 + 0.5 * std::sin(5.0 * t)) *
               Vec3(rate * p.x - 2.5 * p.y, rate * p.y + 2.5 * p.x, rate * p.z);
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

TEST(StatedError, HoldsFromBothSidesForRakesAnywhereInStoredData) {
    const Box box{Vec3(-3), Vec3(3)};
    constexpr std::uint32_t together = 3;
    std::uint32_t seed = 11;
    for (const char* name : {"lamb-oseen", "abc", "rotating-strain", "hill"}) {
        SCOPED_TRACE(name + (" " + std::to_string(seed)));
        expect_true_errors(*sampled(name, box), 3.0, seed, 40, 0.02, together);
        seed += together;
    }
}

TEST(StatedError, CoversVerticesWhereTheFluidExpandsAndWhereItContracts) {
    for (const auto& [kind, name] : every_kind)
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(static_cast<int>(accuracy)));
            std::size_t covered = 0, all = 0;
            for (const double rate : {0.5, 0.2, -0.25, -0.5}) {
                const auto flow = expanding(rate);
                const SurfaceParameters p = asked(*flow, kind, accuracy, 3.0);
                MeasuredErrors sum;
                for (const Rake& rake : rakes(*flow, 3))
                    measure(sum, *flow, rake, p, 60);
                sum.check(accuracy, p.separation, 3.0);
                covered += sum.covered(1e-7 * p.separation);
                all += sum.truth.size();
            }
            EXPECT_GE(static_cast<double>(covered), 0.95 * static_cast<double>(all));
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
                SurfaceParameters p{
                    .kind = kind, .to = kind == SurfaceKind::Time ? 4.5 : 6.0, .separation = 0.15};
                if (kind == SurfaceKind::Time)
                    p.sweep = Vec3(0.5, 0.0, 0.0);
                MeasuredErrors sum;
                measure(sum, *flow, rake, p, 200);
                // Beside the tear the sheet is drawn out so much that cubics along its edges say little.
                sum.check(p.accuracy, p.separation, 3.0 * glm::length(flow->domain().extent()),
                          2.5);
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
