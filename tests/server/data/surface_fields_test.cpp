// The fields of a surface in the states that its clients hold, against formulas: of every kind, in every
// pass, at any time.
#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "server/data/datasets.hpp"
#include "server/live/surface_build.hpp"
#include "tests/support/dequantise.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace wakesurf::server::surface_fields_test {

namespace {

using core::Direction;
using core::SurfaceKind;
using core::Vec3;
using protocol::WireMesh;

constexpr std::array kinds{SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak,
                           SurfaceKind::Time};
constexpr core::UniformGrid grid{{0, 0, 0}, {0.25, 0.25, 0.5}, {17, 9, 5}};
constexpr double height_without_values = 1.75; ///< above it `holes` has none

double pressure(const Vec3& x, double time) {
    return 3.0 * x.x - x.y + 0.5 * x.z + 2.0 * time;
}

/// A shear flow with a scalar linear in space and time, and one with NaN in it.
class ShearStore {
  public:
    ShearStore() {
        store::StoreLayout layout;
        layout.folder = folder_.path();
        layout.grid.uniform = grid;
        layout.times = {0.0, 1.0, 2.5, 4.0};
        layout.scalars = {{"p", "p"}, {"holes", "holes"}};
        for (std::size_t step = 0; step < layout.times.size(); ++step) {
            std::vector<float> velocity, p, holes;
            for (std::size_t node = 0; node < grid.nodes(); ++node) {
                const Vec3 x =
                    grid.origin + grid.spacing * Vec3(node % 17, node / 17 % 9, node / (17 * 9));
                velocity.insert(velocity.end(), {static_cast<float>(0.5 + 0.5 * x.y), 0.0f, 0.0f});
                p.push_back(static_cast<float>(pressure(x, layout.times[step])));
                holes.push_back(x.y > height_without_values
                                    ? std::numeric_limits<float>::quiet_NaN()
                                    : static_cast<float>(5.0 + x.y));
            }
            tests::append_checksums(layout, {tests::put_values(layout, "velocity", step, velocity),
                                             tests::put_values(layout, "p", step, p),
                                             tests::put_values(layout, "holes", step, holes)});
        }
        dataset_.info.velocity = "U";
        dataset_.info.fields = {
            {"U", 3, core::FieldInfo::Source::Point, {}, ""},
            {"heat flux", 3, core::FieldInfo::Source::Point, {}, ""},
            {"p", 1, core::FieldInfo::Source::Point, {}, ""},
            {"holes", 1, core::FieldInfo::Source::Cell, {}, ""},
        };
        dataset_.info.bounds = grid.bounds();
        dataset_.lattice = protocol::lattice_over(grid.bounds());
        dataset_.store = tests::open_layout(layout).value();
        dataset_.scalars =
            store::StoreScalars::open(dataset_.store, std::make_shared<core::PosixDisk>());
        dataset_.flow = core::make_stored_flow(
            std::make_shared<core::TimeStepCache>(dataset_.store, core::TimeStepCache::Options{}));
    }

    const OpenDataset& dataset() const { return dataset_; }

    SurfaceJob job(SurfaceKind kind, const std::vector<std::string>& fields) const {
        SurfaceJob job;
        core::SurfaceParameters p;
        job.epoch = 1;
        const core::Rake rake{core::Rake::Kind::Line, {{2, 0.5, 1}, {2, 1.5, 1}}, 9};
        p.kind = kind;
        p.from = 2.0;
        p.to = 3.5;
        p.separation = 0.1;
        if (kind == SurfaceKind::Time)
            p.sweep = Vec3(0, 0, 0.5);
        job.plan = core::plan_surface(dataset_.flow, rake, p).value();
        job.store = dataset_.store;
        job.scalars = dataset_.scalars;
        job.lattice = dataset_.lattice;
        job.fields = fields_there(dataset_, fields);
        return job;
    }

  private:
    tests::TemporaryFolder folder_;
    OpenDataset dataset_;
};

SurfaceJob strained(SurfaceKind kind) {
    const char* flow =
        "strain?a=0.5,b=0,c=-0.5"; // in the plane of the sheet: area grows as exp(t / 2)
    OpenDataset dataset{*core::describe_analytic_flow(flow), {}, *core::make_analytic_flow(flow)};
    SurfaceJob job;
    core::SurfaceParameters p;
    job.epoch = 1;
    const core::Rake rake{core::Rake::Kind::Line, {{1, -1, 0}, {1, 1, 0}}, 9};
    p.kind = kind;
    p.to = 2.0;
    p.separation = 0.1;
    p.deformation = true;
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3(1, 0, 0);
    job.plan = core::plan_surface(dataset.flow, rake, p).value();
    job.lattice = protocol::lattice_over(dataset.info.bounds);
    job.fields = fields_there(dataset, {"deformation", "approximated"});
    return job;
}

/// What leads to a surface, then where the clock may take it: forth, back, on.
std::vector<SurfacePass> all_passes() {
    return {{Phase::Coarse, 400, {}, 0.2}, {Phase::Refined, 4000, {}, 0.1},
            {Phase::Final, 0, {}, 0.0},    {Phase::Final, 0, 2.6, 0.0},
            {Phase::Live, 0, 2.9, 0.0},    {Phase::Live, 0, 3.2, 0.0},
            {Phase::Final, 0, 2.4, 0.0}};
}

Update update_of(SurfaceBuild& build, const SurfacePass& pass) {
    auto update = build.run(pass, {});
    EXPECT_TRUE(update) << (update ? "" : update.error().message);
    return update ? std::move(*update) : Update{};
}

double value(const WireMesh& state, std::size_t attribute, std::size_t vertex) {
    return state.ranges[attribute].value(state.codes[attribute][vertex]);
}

double width(const WireMesh& state, std::size_t attribute) {
    return double{state.ranges[attribute].hi} - double{state.ranges[attribute].lo};
}

/// What codes and the lattice round away, and what a live state may leave.
double rounding(const WireMesh& state, std::size_t attribute, bool lossless) {
    return (lossless ? 1.0 : 130.0) * width(state, attribute) / 65535.0 + (lossless ? 1e-3 : 2e-3);
}

} // namespace

TEST(SurfaceFields, AScalarIsWhatTheFormulaSaysWhereAndWhenEachVertexIs) {
    const core::SteadyClock clock;
    const ShearStore store;
    for (const SurfaceKind kind : kinds) {
        SurfaceBuild build(store.job(kind, {"p"}), clock);
        for (const SurfacePass& pass : all_passes()) {
            const Update update = update_of(build, pass);
            const WireMesh& state = *update.wire.state;
            ASSERT_EQ(state.codes.size(), 4u);
            ASSERT_GT(state.vertices(), 20u);
            const double near = rounding(state, 3, update.wire.lossless);
            for (std::size_t v = 0; v < state.vertices(); ++v) {
                const double time = kind == SurfaceKind::Stream ? 2.0
                                    : kind == SurfaceKind::Path ? 2.0 + value(state, 2, v)
                                                                : update.time;
                ASSERT_NEAR(
                    value(state, 3, v),
                    pressure(tests::dequantise(store.dataset().lattice, state.position[v]), time),
                    near)
                    << "kind " << static_cast<int>(kind) << " at " << update.time;
            }
        }
    }
}

TEST(SurfaceFields, BothSidesOfAPathSurfaceAreSampledAtTheTimeAtWhichEachVertexIsThere) {
    const core::SteadyClock clock;
    const ShearStore store;
    SurfaceJob job = store.job(SurfaceKind::Path, {"p"});
    job.plan.parameters.direction = Direction::Both;
    SurfaceBuild build(job, clock);
    for (const SurfacePass& pass :
         {SurfacePass{Phase::Final, 0, {}, 0.0}, SurfacePass{Phase::Final, 0, 2.8, 0.0}}) {
        const WireMesh& state = *update_of(build, pass).wire.state;
        std::array<int, 2> seen{};
        for (std::size_t v = 0; v < state.vertices(); ++v) {
            const Vec3 x = tests::dequantise(job.lattice, state.position[v]);
            if (std::abs(x.x - 2.0) < 1e-3)
                continue; // on the rake both meet
            const bool forward = x.x > 2.0;
            ++seen[forward ? 0 : 1];
            ASSERT_NEAR(value(state, 3, v), pressure(x, 2.0 + value(state, 2, v)),
                        rounding(state, 3, true));
        }
        EXPECT_GT(seen[0], 20);
        EXPECT_GT(seen[1], 20);
    }
}

TEST(SurfaceFields, ValuesThatAreMissingAreSentAsMissing) {
    const core::SteadyClock clock;
    const ShearStore store;
    for (const SurfaceKind kind : kinds) {
        SurfaceJob job = store.job(kind, {"holes"});
        core::SurfaceParameters p = job.plan.parameters;
        p.to = 3.0; // what flows fastest stays in the domain
        const core::Rake rake{core::Rake::Kind::Line, {{2, 1.0, 1}, {2, 2.0, 1}}, 9};
        job.plan = core::plan_surface(job.plan.flow, rake, p).value();
        SurfaceBuild build(job, clock);
        for (const SurfacePass& pass : all_passes()) {
            const Update update = update_of(build, pass);
            const WireMesh& state = *update.wire.state;
            std::size_t missing = 0;
            for (std::size_t v = 0; v < state.vertices(); ++v) {
                const double y = tests::dequantise(job.lattice, state.position[v]).y;
                if (std::abs(y - 1.75) < 1e-3 || std::abs(y - 1.5) < 1e-3)
                    continue; // where the cells with holes begin
                if (y > 1.75) {
                    ++missing;
                    ASSERT_TRUE(std::isnan(value(state, 3, v))) << y;
                } else {
                    ASSERT_NEAR(value(state, 3, v), 5.0 + y,
                                rounding(state, 3, update.wire.lossless))
                        << y;
                }
            }
            EXPECT_GT(missing, 4u) << "kind " << static_cast<int>(kind) << " at " << update.time;
        }
    }
}

TEST(SurfaceFields, DeformationIsTheAreaRatioOfTheFlowMapInEveryPass) {
    const core::SteadyClock clock;
    for (const SurfaceKind kind : kinds) {
        SurfaceBuild build(strained(kind), clock);
        for (SurfacePass pass : all_passes()) {
            if (pass.time)
                *pass.time -= 2.0;
            const Update update = update_of(build, pass);
            const WireMesh& state = *update.wire.state;
            ASSERT_EQ(state.codes.size(), 5u);
            double most = 0.0;
            for (std::size_t v = 0; v < state.vertices(); ++v) {
                const double t = value(state, 2, v);
                const double age = kind == SurfaceKind::Time     ? update.time
                                   : kind == SurfaceKind::Streak ? update.time - t // of the release
                                                                 : t;
                ASSERT_NEAR(value(state, 3, v), 0.5 * age / std::numbers::ln2, 0.02)
                    << "kind " << static_cast<int>(kind) << " at " << update.time;
                most = std::max(most, value(state, 3, v));
            }
            EXPECT_GT(most, 0.2);
        }
    }
}

// The flow shears at 0.5 / s: so much it turns, and turning and straining are equal.
TEST(SurfaceFields, VorticityAndQAreThoseOfTheShearInEveryPass) {
    const core::SteadyClock clock;
    const ShearStore store;
    for (const SurfaceKind kind : kinds) {
        SurfaceBuild build(store.job(kind, {"vorticity", "q_criterion"}), clock);
        for (const SurfacePass& pass : all_passes()) {
            const Update update = update_of(build, pass);
            const WireMesh& state = *update.wire.state;
            ASSERT_EQ(state.codes.size(), 5u);
            for (std::size_t v = 0; v < state.vertices(); ++v) {
                ASSERT_NEAR(value(state, 3, v), 0.5, 1e-5) << static_cast<int>(kind);
                ASSERT_NEAR(value(state, 4, v), 0.0, 1e-5) << static_cast<int>(kind);
            }
        }
    }
}

TEST(SurfaceFields, ApproximatedMarksAsManyVerticesAsTheStatisticsCount) {
    const core::SteadyClock clock;
    for (const SurfaceKind kind : kinds) {
        SurfaceJob job = strained(kind);
        job.plan.flow = *core::make_analytic_flow("abc");
        job.lattice = protocol::lattice_over(core::describe_analytic_flow("abc")->bounds);
        SurfaceBuild build(job, clock);
        const Update update = update_of(build, {Phase::Final, 0, {}, 0.0});
        const WireMesh& state = *update.wire.state;
        std::uint64_t marked = 0;
        for (std::size_t v = 0; v < state.vertices(); ++v) {
            const double mark = value(state, 4, v);
            ASSERT_TRUE(mark == 0.0 || mark == 1.0) << mark;
            marked += mark == 1.0 ? 1 : 0;
        }
        EXPECT_EQ(marked, update.statistics.approximated) << static_cast<int>(kind);
    }
}

TEST(SurfaceFields, TheErrorOfTheVerticesIsWhatTheStatisticsSayOfThem) {
    const core::SteadyClock clock;
    for (const SurfaceKind kind : kinds) {
        SurfaceJob job = strained(kind);
        job.plan.flow = *core::make_analytic_flow("abc");
        job.lattice = protocol::lattice_over(core::describe_analytic_flow("abc")->bounds);
        OpenDataset dataset;
        job.fields = fields_there(dataset, {"error"});
        ASSERT_EQ(job.fields.size(), 1u);
        SurfaceBuild build(job, clock);
        for (SurfacePass pass : all_passes()) {
            if (pass.time)
                *pass.time -= 2.0;
            const Update update = update_of(build, pass);
            const WireMesh& state = *update.wire.state;
            std::vector<double> all;
            for (std::size_t v = 0; v < state.vertices(); ++v)
                all.push_back(value(state, 3, v));
            std::sort(all.begin(), all.end());
            const double at99 = all.at(
                static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(all.size() - 1))));
            // Nothing is sent where nothing is estimated.
            const double stated = update.statistics.error ? update.statistics.error->error99 : 0.0;
            const double step = width(state, 3) / 65535.0;
            EXPECT_NEAR(at99, stated, (update.wire.lossless ? 1.0 : 130.0) * step)
                << static_cast<int>(kind) << " at " << update.time;
            if (kind == SurfaceKind::Stream || kind == SurfaceKind::Path) {
                EXPECT_GT(stated, 0.0);
                EXPECT_GT(all.back(), 0.0);
            }
        }
    }
}

TEST(SurfaceFields, ComponentsOfTheVelocityHaveTheSpeedForTheirLength) {
    const core::SteadyClock clock;
    const ShearStore store;
    for (const SurfaceKind kind : kinds) {
        SurfaceBuild build(store.job(kind, {"velocity_x", "velocity_y", "velocity_z"}), clock);
        const Update update = update_of(build, {Phase::Final, 0, {}, 0.0});
        const WireMesh& state = *update.wire.state;
        ASSERT_GT(state.vertices(), 0u);
        for (std::size_t v = 0; v < state.vertices(); ++v)
            ASSERT_NEAR(std::hypot(value(state, 3, v), value(state, 4, v), value(state, 5, v)),
                        value(state, 0, v), 1e-4);
    }
}

TEST(SurfaceFields, NormalsAreOfLengthOneAndAreThereInEveryKind) {
    const core::SteadyClock clock;
    const ShearStore store;
    for (const SurfaceKind kind : kinds) {
        SurfaceJob job = store.job(kind, {"normal_x", "normal_y", "normal_z"});
        job.plan.parameters.tangents = true;
        SurfaceBuild build(std::move(job), clock);
        const Update update = update_of(build, {Phase::Final, 0, {}, 0.0});
        const WireMesh& state = *update.wire.state;
        ASSERT_GT(state.vertices(), 0u);
        for (std::size_t v = 0; v < state.vertices(); ++v)
            ASSERT_NEAR(std::hypot(value(state, 3, v), value(state, 4, v), value(state, 5, v)), 1.0,
                        1e-4);
    }
}

TEST(SurfaceFields, AMeshIsTheSameWithFieldsAndWithout) {
    const core::SteadyClock clock;
    const ShearStore store;
    for (const SurfaceKind kind : kinds) {
        SurfaceBuild plain(store.job(kind, {}), clock);
        SurfaceBuild rich(store.job(kind, {"p", "U", "approximated"}), clock);
        int compared = 0;
        for (const SurfacePass& pass : all_passes()) {
            const Update without = update_of(plain, pass);
            const Update with = update_of(rich, pass);
            // A delta leaves vertices in their places, a key frame puts them in order; which is smaller
            // depends on the fields.
            if (!with.wire.lossless || with.wire.key != without.wire.key)
                continue;
            ++compared;
            EXPECT_EQ(without.wire.state->position, with.wire.state->position);
            EXPECT_EQ(without.wire.state->cells(), with.wire.state->cells());
            ASSERT_EQ(without.wire.state->codes.size(), 3u);
            ASSERT_EQ(with.wire.state->codes.size(), 6u);
            const WireMesh& state = *with.wire.state;
            for (std::size_t v = 0; v < state.vertices(); ++v)
                ASSERT_NEAR(value(state, 4, v), value(state, 0, v), 1e-4)
                    << "the velocity's magnitude";
        }
        EXPECT_GE(compared, 4);
    }
}

TEST(SurfaceFields, NamesAreFoundInTheDatasetFirst) {
    const ShearStore store;
    using Source = SurfaceField::Source;
    EXPECT_EQ(find_field(store.dataset(), "p").value(), (SurfaceField{"p", Source::Scalar}));
    EXPECT_EQ(find_field(store.dataset(), "holes").value(),
              (SurfaceField{"holes", Source::Scalar}));
    EXPECT_EQ(find_field(store.dataset(), "U").value().source, Source::Speed);
    EXPECT_EQ(find_field(store.dataset(), "deformation").value().source, Source::Deformation);
    const auto unknown = find_field(store.dataset(), "T");
    EXPECT_EQ(unknown.error().code, core::Error::Code::InvalidArgument);
    EXPECT_EQ(unknown.error().hint,
              "there is p, holes, U, deformation, approximated, error, vorticity, "
              "vorticity_x, vorticity_y, vorticity_z, q_criterion, velocity_x, velocity_y, "
              "velocity_z, normal_x, normal_y, normal_z, twin_distance, twin_lag");
    EXPECT_TRUE(find_field(store.dataset(), "vorticty")
                    .error()
                    .hint.starts_with("did you mean vorticity? There is p, holes, U, "));
    const auto vector = find_field(store.dataset(), "heat flux");
    EXPECT_NE(vector.error().message.find("a store holds one vector"), std::string::npos);
    const auto names = [&](const std::vector<std::string>& asked) {
        std::vector<std::string> out;
        for (const SurfaceField& each : fields_there(store.dataset(), asked))
            out.push_back(each.name);
        return out;
    };
    EXPECT_EQ(names({"T", "p", "p", "holes", "deformation", "U", "approximated", "error"}),
              (std::vector<std::string>{"p", "holes", "deformation", "U", "approximated"}));
}

TEST(SurfaceFields, AreAskedForOnceEach) {
    const ShearStore store;
    const auto once = fields_once(store.dataset(), {"p", "deformation", "p"});
    ASSERT_TRUE(once);
    EXPECT_EQ(*once, (std::vector<std::string>{"p", "deformation"}));
    EXPECT_EQ(fields_once(store.dataset(), {"q"}).error().code, core::Error::Code::InvalidArgument);
}

} // namespace wakesurf::server::surface_fields_test
