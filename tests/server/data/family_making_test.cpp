#include "core/field/sample_scalar.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "server/data/dataset_argument.hpp"
#include "server/data/family_making.hpp"
#include "store/store_generation.hpp"
#include "tests/support/level_set.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstring>

namespace wakesurf::server::family_making_test {
namespace {

using namespace tests;

using core::Error;
using Kind = core::Rake::Kind;

LoadedDataset opened(const std::string& path, const TemporaryFolder& stores) {
    return resolve_dataset(path)
        .and_then([&](const DatasetArgument& argument) {
            return open_dataset(argument, {stores.path(), {}}, [](const store::ImportProgress&) {});
        })
        .value();
}

LoadedDataset generated(const std::string& flow,
                        const core::UniformGrid& grid,
                        const TemporaryFolder& folder,
                        std::vector<double> times = {0.0}) {
    EXPECT_TRUE(store::generate_store({flow, grid, std::move(times)}, folder / "store",
                                      [](const store::ImportProgress&) {}, {}));
    return opened(folder / "store", folder);
}

const core::UniformGrid small{{-2, -2, -2}, {0.5, 0.5, 0.5}, {9, 9, 9}};

FamilyWish wish(const std::string& name, core::FamilyRequest request) {
    return {name, std::move(request), {}};
}

std::vector<float> kept(const LoadedDataset& dataset, const std::string& name, std::size_t step) {
    const auto now = with_kept_fields(dataset, {});
    const auto slab = now.scalars->scalar_values(now.scalars->find(name).value(), step, {}).value();
    const auto* begin = reinterpret_cast<const float*>(slab->bytes().data());
    return {begin, begin + slab->bytes().size() / sizeof(float)};
}

TEST(FamilyMaking, LiesWithinACellOfTheStreamSurfaceOfTheBundledSimulation) {
    const TemporaryFolder folder;
    const auto dataset = opened((source_folder() / "data/sqcyl/sqcyl.pvd").string(), folder);
    const auto& grid = std::get<core::UniformGrid>(dataset.store->grid());
    const core::Box box = grid.bounds();
    // Up the whole height, above the middle of the body, where the flow is not torn apart.
    const double x = box.lo.x + 0.1 * box.extent().x;
    const double y = box.lo.y + 0.62 * box.extent().y;
    const core::Rake rake{Kind::Line, {{x, y, box.lo.z}, {x, y, box.hi.z}}};
    const auto made = make_family(dataset, wish("psi", {rake}), {});
    ASSERT_TRUE(made) << made.error().message;
    const auto& counts = made->steps.front().counts;
    EXPECT_GT(counts.reached, counts.nodes / 2);
    EXPECT_GT(counts.obstacle, 0u);
    const auto values = kept(dataset, "psi", 0);
    core::SurfaceParameters parameters;
    parameters.from = dataset.info.times.front();
    parameters.to = parameters.from + 60.0;
    parameters.separation = 0.4 * dataset.info.finest_spacing;
    const auto surface = core::build_surface(*dataset.flow, rake, parameters);
    ASSERT_TRUE(surface) << surface.error().message;
    const double cell = std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    const NearPoints level(level_points(grid, values, 0.0), 2.0 * cell);
    double farthest = 0.0;
    std::size_t looked = 0;
    for (const core::Vec3& p : surface->mesh.position)
        if (all_known(grid, values, p)) {
            farthest = std::max(farthest, level.distance(p));
            ++looked;
        }
    EXPECT_GT(looked, 500u);
    EXPECT_LE(farthest, cell);
}

TEST(FamilyMaking, IsConstantAlongCurvesDownstream) {
    const TemporaryFolder folder;
    const auto dataset =
        generated("cylinder", {{-4, -2, -1}, {0.125, 0.125, 0.25}, {65, 33, 9}}, folder);
    ASSERT_TRUE(make_family(dataset, wish("psi", {core::FamilyInflow{}, "y"}), {}));
    const auto now = with_kept_fields(dataset, {});
    std::vector<core::Curve> curves;
    for (int i = 0; i < 40; ++i) {
        core::Curve curve; // those closer to the body pass where the scalar changes within a cell
        curve.seed = {-3.9, (i % 2 == 0 ? 1.0 : -1.0) * (0.6 + 0.03 * i), -0.5};
        curve.duration = 4.0;
        curves.push_back(curve);
    }
    core::TraceOptions options;
    options.frozen = true;
    options.longest_step = 0.125;
    ASSERT_TRUE(dataset.flow->trace(curves, options, {}));
    double worst = 0.0;
    for (const core::Curve& curve : curves) {
        std::vector<core::Vec3> points;
        for (int i = 0; i <= 20; ++i)
            points.push_back(curve.at_arc(curve.last.arc * i / 20.0).position);
        const std::vector<double> times(points.size(), 0.0);
        const auto values = core::sample_scalar(*dataset.flow, *now.scalars,
                                                now.scalars->find("psi").value(), points, times, {})
                                .value();
        for (const float value : values)
            if (std::isfinite(value) && std::isfinite(values[0]))
                worst = std::max(worst, double(std::abs(value - values[0])));
    }
    EXPECT_LT(worst, 0.125 * 0.25) << "a quarter of a cell, for what is between the nodes";
}

TEST(FamilyMaking, IsTheSameOnAnyNumberOfThreads) {
    const TemporaryFolder folder;
    const auto dataset = generated("abc?A=1,B=1,C=0.5", small, folder);
    std::vector<std::vector<float>> all;
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 3);
    for (const int threads : {1, 3}) {
        tbb::task_arena arena(threads);
        const std::string name = "on" + std::to_string(threads);
        const auto made = arena.execute([&] {
            return make_family(dataset, wish(name, {core::FamilyInflow{}, "x"}), {});
        });
        ASSERT_TRUE(made) << made.error().message;
        all.push_back(kept(dataset, name, 0));
    }
    EXPECT_EQ(std::memcmp(all[0].data(), all[1].data(), all[0].size() * sizeof(float)), 0);
}

TEST(FamilyMaking, BeginsWithAFieldOfTheDatasetAndOfAnotherFamily) {
    const TemporaryFolder folder;
    const auto dataset = generated("uniform?u=1", small, folder);
    ASSERT_TRUE(make_family(dataset, wish("height", {core::FamilyInflow{}, "z"}), {}));
    const auto now = with_kept_fields(dataset, {});
    ASSERT_TRUE(
        make_family(now, wish("again", {core::FamilyPlane{{1, 0, 0}, {1, 0, 0}}, "height"}), {}));
    EXPECT_EQ(kept(dataset, "again", 0), kept(dataset, "height", 0));
}

TEST(FamilyMaking, IsMadeForTheTimeStepsAskedForAndHasNoValueAtOthers) {
    const TemporaryFolder folder;
    const auto dataset = generated("oscillating", small, folder, {0.0, 0.5, 1.0, 1.5});
    FamilyWish some = wish("psi", {core::FamilyInflow{}, "y"});
    some.times = {1.1, 0.4};
    const auto made = make_family(dataset, some, {});
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->steps.size(), 2u);
    EXPECT_EQ(made->steps[0].index, 1u);
    EXPECT_EQ(made->steps[1].time, 1.0);
    EXPECT_NE(kept(dataset, "psi", 1), kept(dataset, "psi", 2));
    for (const float value : kept(dataset, "psi", 3))
        EXPECT_TRUE(std::isnan(value));
}

TEST(FamilyMaking, EndsWhenItIsStoppedAndKeepsNothing) {
    const TemporaryFolder folder;
    const auto dataset = generated("abc", small, folder);
    std::stop_source stop;
    stop.request_stop();
    const auto made =
        make_family(dataset, wish("psi", {core::FamilyInflow{}, "y"}), stop.get_token());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, Error::Code::Cancelled);
    EXPECT_TRUE(with_kept_fields(dataset, {}).scalars->families().empty());
}

TEST(FamilyMaking, CountsItsMemoryAndRefusesWhatDoesNotFit) {
    const TemporaryFolder folder;
    const auto dataset = generated("uniform", small, folder);
    const core::MemoryAccount account(4096);
    core::WorkMemory memory(account, {}, std::chrono::milliseconds(1), "this family");
    const auto made =
        make_family(dataset, wish("psi", {core::FamilyInflow{}, "y"}), {}, {nullptr, &memory});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, Error::Code::OverLimit);
}

struct Refused {
    const char* flow;
    FamilyWish wish;
    Error::Code code;
    const char* words;
};

TEST(FamilyMaking, RefusesWhatMakesNoFamilyAndLosesNothing) {
    const core::Rake bent{Kind::Polyline, {{0, -1, 0}, {0, 0, 0}, {0, 1, 1}, {1, 1, 1}}};
    const core::Rake along{Kind::Line, {{-1, 0, 0}, {1, 0, 0}}};
    const core::Rake away{Kind::Line, {{50, 0, 0}, {50, 1, 0}}};
    const core::FamilyInflow inflow;
    using Code = Error::Code;
    const std::vector<Refused> all{
        {"uniform", wish("there", {inflow, "y"}), Code::InvalidArgument, "already"},
        {"uniform", wish("velocity", {inflow, "y"}), Code::InvalidArgument, "already"},
        {"uniform", wish("q_criterion", {inflow, "y"}), Code::InvalidArgument, "already"},
        {"uniform", wish("../psi", {inflow, "y"}), Code::InvalidArgument, "letters"},
        {"uniform", wish("", {inflow, "y"}), Code::InvalidArgument, "letters"},
        {"uniform", wish("psi", {inflow, "temperature"}), Code::InvalidArgument, "temperature"},
        {"uniform", wish("psi", {core::FamilyPlane{{9, 0, 0}, {1, 0, 0}}}), Code::OutOfDomain,
         "outside the domain by 7"},
        {"uniform", wish("psi", {core::FamilyPlane{{0, 0, 0}, {0, 0, 0}}}), Code::InvalidArgument,
         "normal"},
        {"uniform", wish("psi", {core::FamilyPlane{{0, 0, 0}, {0, 1, 0}}}), Code::InvalidArgument,
         "runs along the plane"},
        {"uniform", wish("psi", {along}), Code::InvalidArgument, "runs along the curve"},
        {"uniform", wish("psi", {bent}), Code::InvalidArgument, "not planar"},
        {"uniform", wish("psi", {away}), Code::OutOfDomain, "outside the domain"},
        {"uniform", {"psi", {inflow, "y"}, {7.0}}, Code::OutOfTime, "outside the data's"},
        {"uniform?u=0", wish("psi", {inflow, "y"}), Code::InvalidArgument, "velocity is zero"},
    };
    for (const Refused& each : all) {
        SCOPED_TRACE(each.words);
        const TemporaryFolder folder;
        auto dataset = generated(each.flow, small, folder);
        if (each.wish.name == "there") {
            ASSERT_TRUE(make_family(dataset, each.wish, {}));
        }
        dataset = with_kept_fields(dataset, {});
        const auto before = dataset.scalars->names();
        const auto made = make_family(dataset, each.wish, {});
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().code, each.code) << made.error().message;
        EXPECT_NE(made.error().message.find(each.words), std::string::npos) << made.error().message;
        EXPECT_EQ(with_kept_fields(dataset, {}).scalars->names(), before);
    }
}

TEST(FamilyMaking, RefusesADatasetWithoutInflow) {
    const TemporaryFolder folder;
    // Every streamline closes within the box: none comes from its boundary.
    const auto dataset =
        generated("double-gyre?eps=0,w=0", {{0, 0, 0}, {0.125, 0.125, 0.5}, {17, 9, 3}}, folder);
    const auto made = make_family(dataset, wish("psi", {core::FamilyInflow{}, "y"}), {});
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message.find("no inflow"), std::string::npos) << made.error().message;
    EXPECT_TRUE(with_kept_fields(dataset, {}).scalars->families().empty());
}

TEST(FamilyMaking, RefusesABuiltInFlow) {
    const auto dataset = open_flow(resolve_dataset("flow:abc").value()).value();
    const auto made = make_family(dataset, wish("psi", {core::FamilyInflow{}, "y"}), {});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, Error::Code::Unsupported);
}

} // namespace
} // namespace wakesurf::server::family_making_test
