// Fields of stores at their nodes, and level sets of them against closed forms; many that ask at once, and without memory.
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_surface.hpp"
#include "protocol/wire/mesh_decoder.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "server/data/node_fields.hpp"
#include "server/live/compute/compute_pool.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/mesh_borders.hpp"
#include "tests/support/scalar_store.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <future>
#include <limits>
#include <mutex>
#include <thread>

namespace wakesurf::server::node_fields_test {
namespace {

using core::Error;
using core::Vec3;

constexpr double radius = 0.6;

double distance(const Vec3& x, double) {
    return glm::length(x);
}

double height(const Vec3& x, double time) {
    return x.z + 0.5 * time;
}

core::UniformGrid cube(std::uint32_t n) {
    return {Vec3(-1.0), Vec3(2.0 / (n - 1)), {n, n, n}};
}

struct Data {
    explicit Data(const core::Grid& grid,
                  const std::vector<std::pair<std::string, tests::ScalarFormula>>& scalars =
                      {{"r", distance}, {"h", height}},
                  const NodeFields::Options& options = {},
                  const std::function<bool(const Vec3&)>& solid = {})
        : store(grid, {0.0, 1.0}, scalars, solid),
          levels(std::make_shared<NodeFields>(store.flow(), store.reader(), "U", options)) {}

    core::Result<core::Surface> surface(const std::string& field,
                                        double level,
                                        double time = 0.0,
                                        std::uint64_t quads = 1'000'000) const {
        core::SurfaceParameters p;
        p.kind = core::SurfaceKind::Level;
        p.from = p.to = time;
        p.field = field;
        p.level = level;
        p.max_quads = quads;
        auto plan = core::plan_surface(store.flow(), {}, p);
        return core::take_levels(*plan, levels).and_then([&] {
            return core::build_surface(*plan);
        });
    }

    core::QuadComplex mesh(const std::string& field, double level, double time = 0.0) const {
        auto built = surface(field, level, time);
        EXPECT_TRUE(built) << (built ? "" : built.error().message);
        return built ? built->mesh : core::QuadComplex{};
    }

    tests::ScalarStore store;
    std::shared_ptr<const NodeFields> levels;
};

/// The largest distance of a vertex from the sphere.
double off_sphere(const core::QuadComplex& mesh) {
    double most = 0.0;
    for (const Vec3& x : mesh.position)
        most = std::max(most, std::abs(glm::length(x) - radius));
    return most;
}

long euler(const core::QuadComplex& mesh) {
    const tests::DirectedEdges edges(mesh);
    return static_cast<long>(mesh.vertices()) - static_cast<long>(edges.all().size() / 2) +
           static_cast<long>(mesh.cells.size());
}

void expect_sphere(const core::QuadComplex& mesh, double cell) {
    ASSERT_FALSE(mesh.cells.empty());
    EXPECT_LT(off_sphere(mesh), 0.5 * cell * cell / radius);
    EXPECT_TRUE(tests::border_edges(mesh).empty());
    EXPECT_EQ(euler(mesh), 2);
    EXPECT_EQ(tests::component_sizes(mesh).size(), 1u);
}

TEST(LevelSets, OfADistanceAreASphereToSecondOrderAndClosed) {
    double before = 0.0;
    for (const std::uint32_t n : {16u, 32u, 64u}) {
        const Data data{cube(n)};
        const auto mesh = data.mesh("r", radius);
        expect_sphere(mesh, 2.0 / (n - 1));
        if (before > 0.0) {
            EXPECT_GT(std::log2(before / off_sphere(mesh)), 1.7) << n;
        }
        before = off_sphere(mesh);
    }
}

TEST(LevelSets, OfARectilinearGridLieWhereItsNodesAre) {
    core::RectilinearGrid grid;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i <= 40; ++i) {
            const double at = i / 20.0 - 1.0;
            grid.coordinates[static_cast<std::size_t>(k)].push_back(at + 0.1 * (k + 1) * at *
                                                                             (1.0 - at * at));
        }
    expect_sphere(Data(grid).mesh("r", radius), 0.065);
}

TEST(LevelSets, OfAMeshOfCellsAreTheSame) {
    const auto mesh =
        tests::block({24, 24, 24}, [](const Vec3& u) { return 2.0 * tests::wavy(u) - Vec3(1.0); });
    expect_sphere(Data(mesh).mesh("r", radius), 0.12);
}

TEST(LevelSets, OfTetrahedraPyramidsAndHexahedraTogetherAreClosed) {
    using Kind = tests::TwoToOne::Kind;
    tests::TwoToOne mesh(
        12, [](const Vec3& at) { return at.x > 0.5 ? Kind::Fine : Kind::Coarse; },
        [](const Vec3& u) { return 2.0 * u - Vec3(1.0); });
    expect_sphere(Data(mesh.take()).mesh("r", radius), 0.17);
}

TEST(LevelSets, OfTwoFieldsAtOneLevelAreApart) {
    const Data data{cube(24)};
    const auto sphere = data.mesh("r", 0.25);
    for (const Vec3& x : data.mesh("h", 0.25).position)
        EXPECT_NEAR(x.z, 0.25, 1e-6);
    EXPECT_EQ(data.mesh("r", 0.25).position, sphere.position) << "again, after the other";
}

TEST(LevelSets, AreOfTheTimeAskedForBetweenTimeSteps) {
    const Data data{cube(9)};
    for (const double time : {0.0, 0.25, 1.0})
        for (const Vec3& x : data.mesh("h", 0.3, time).position)
            EXPECT_NEAR(x.z, 0.3 - 0.5 * time, 1e-6);
}

TEST(LevelSets, OfFieldsThatAreDerivedFromTheVelocity) {
    const Data data{cube(9)};
    EXPECT_TRUE(data.mesh("U", 1.0).cells.empty()) << "it is 1 everywhere";
    EXPECT_EQ(data.surface("velocity_y", 0.5)->statistics.empty->message,
              "level 0.5 is outside the range of velocity_y, 0 to 0");
    EXPECT_EQ(data.surface("nope", 1.0).error().code, Error::Code::NotFound);
    EXPECT_EQ(data.surface("q_criterium", 1.0).error().hint.substr(0, 46),
              "did you mean q_criterion? There is r, h, U, vo");
}

/// Nothing of `mesh` comes nearer to where there are no values than a cell's own size.
void expect_hole(const core::QuadComplex& mesh, double edge) {
    ASSERT_FALSE(mesh.cells.empty());
    for (const Vec3& x : mesh.position) {
        EXPECT_TRUE(core::finite(x));
        EXPECT_NEAR(glm::length(x), radius, 0.02) << "no spikes";
        EXPECT_LE(x.x, edge + 1e-9);
    }
    EXPECT_EQ(tests::border_loops(mesh), 1u) << "a hole";
}

TEST(LevelSets, HaveHolesWhereNodesHaveNoValue) {
    const auto cut = [](const Vec3& x, double time) {
        return x.x > 0.31 ? std::numeric_limits<double>::quiet_NaN() : distance(x, time);
    };
    expect_hole(Data(cube(41), {{"r", cut}}).mesh("r", radius), 0.3);
    expect_hole(Data(tests::block({40, 40, 40}, [](const Vec3& u) { return 2.0 * u - Vec3(1.0); }),
                     {{"r", cut}})
                    .mesh("r", radius),
                0.3);
    expect_hole(Data(cube(41), {{"r", distance}}, {}, [](const Vec3& x) { return x.x > 0.31; })
                    .mesh("r", radius),
                0.3);
    const auto nowhere = [](const Vec3&, double) {
        return std::numeric_limits<double>::quiet_NaN();
    };
    EXPECT_EQ(Data(cube(9), {{"r", nowhere}}).surface("r", radius)->statistics.empty->message,
              "r has no values");
}

TEST(LevelSets, ThroughNodesThatHaveTheLevelStayClosed) {
    const auto diamond = [](const Vec3& x, double) {
        return std::abs(x.x) + std::abs(x.y) + std::abs(x.z);
    };
    const auto mesh = Data(cube(9), {{"d", diamond}}).mesh("d", 0.5);
    EXPECT_TRUE(tests::border_edges(mesh).empty());
    EXPECT_EQ(euler(mesh), 2);
}

TEST(LevelSets, OfMoreTrianglesThanAllowedAreRefusedAndTheNextOneIsExtracted) {
    const Data data{cube(32)};
    const auto refused = data.surface("r", radius, 0.0, 100);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Error::Code::OverLimit);
    EXPECT_NE(refused.error().message.find("more than `maxQuads` 100"), std::string::npos)
        << refused.error().message;
    EXPECT_TRUE(data.surface("r", radius));
}

TEST(LevelSets, GivenUpAreNotTheAnswerToTheNext) {
    const Data data{cube(16)};
    const auto before = data.mesh("h", 0.25);
    std::stop_source stop;
    stop.request_stop();
    for (int i = 0; i < 5; ++i)
        (void)data.levels->values("r", 0.0, stop.get_token());
    EXPECT_EQ(data.mesh("h", 0.25).position, before.position);
}

TEST(LevelSets, CountTheirFieldAndGiveItBackWhenOthersNeedIt) {
    const core::MemoryAccount account(std::size_t{1} << 30);
    const Data data(cube(16), {{"r", distance}}, {account});
    EXPECT_EQ(account.used(core::MemoryUse::Histories), 0u);
    (void)data.mesh("r", radius);
    EXPECT_EQ(account.used(core::MemoryUse::Histories), 16u * 16 * 16 * sizeof(float));
    account.make_room(account.budget());
    EXPECT_EQ(account.used(core::MemoryUse::Histories), 0u);
    expect_sphere(data.mesh("r", radius), 2.0 / 15);

    const core::MemoryAccount little(std::size_t{8} << 10);
    EXPECT_EQ(Data(cube(16), {{"r", distance}}, {little}).surface("r", radius).error().code,
              Error::Code::OverLimit);
}

TEST(LevelSets, OfTheFieldOfBeforeReadNothingAgain) {
    const Data data{cube(9)};
    const auto first = data.levels->values("r", 0.0, {}).value();
    EXPECT_EQ(data.levels->values("r", 0.0, {}).value(), first) << "the same values in memory";
    EXPECT_NE(data.levels->values("r", 0.5, {}).value(), first);
    EXPECT_EQ(first->range[0], 0.0) << "held as long as they are used";
}

/// Time-steps that never come.
class NoTimeSteps final : public core::TimeStepSource {
  public:
    explicit NoTimeSteps(const store::StoreReader& reader) : reader_(reader) {}

    const core::Grid& grid() const override { return reader_.grid(); }

    const core::SolidMask& mask() const override { return reader_.mask(); }

    const std::vector<double>& times() const override { return reader_.times(); }

    bool ready(std::size_t) const override { return true; }

    std::size_t bytes_per_step() const override { return reader_.bytes_per_step(); }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t,
                                                             std::stop_token stop) const override {
        std::unique_lock lock(mutex_);
        ++asked;
        asked.notify_all();
        stopped_.wait(lock, stop, [] { return false; });
        return core::fail(Error::Code::Cancelled, "stopped");
    }

    mutable std::atomic<int> asked{0};

  private:
    const store::StoreReader& reader_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any stopped_;
};

TEST(LevelSets, ThatWaitForAFieldKeepNoPlaceOfTheComputePoolAndEndWhenTheyAreStopped) {
    const tests::ScalarStore store(cube(9), {0.0, 1.0}, {{"r", distance}});
    const auto source = std::make_shared<NoTimeSteps>(*store.reader());
    const NodeFields fields(core::make_stored_flow(std::make_shared<core::TimeStepCache>(
                                source, core::TimeStepCache::Options{})),
                            store.reader(), "U", {});
    std::stop_source stop;
    std::atomic<int> cancelled{0};
    ComputePool pool(2);
    for (int i = 0; i < 8; ++i)
        pool.run("level" + std::to_string(i), PriorityClass::Long, [&] {
            const auto found = fields.values("U", 0.0, stop.get_token());
            cancelled += !found && found.error().code == Error::Code::Cancelled ? 1 : 0;
            cancelled.notify_all();
        });
    source->asked.wait(0);
    std::promise<void> ninth;
    pool.run("stream", PriorityClass::Long, [&] { ninth.set_value(); });
    EXPECT_EQ(ninth.get_future().wait_for(std::chrono::seconds(10)), std::future_status::ready);
    stop.request_stop();
    for (int now = cancelled; now < 8; now = cancelled)
        cancelled.wait(now);
    EXPECT_EQ(fields.values("r", 0.0, {}).value()->range[0], 0.0) << "the next one is loaded";
}

TEST(LevelSets, MayBeAskedForByManyThreads) {
    const Data data{cube(16)};
    const auto sphere = data.mesh("r", radius);
    const auto plane = data.mesh("h", 0.25);
    std::vector<std::jthread> threads;
    std::atomic<int> same{0};
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            for (int k = 0; k < 5; ++k)
                same += i % 2 == 0 ? data.mesh("r", radius).position == sphere.position
                                   : data.mesh("h", 0.25).position == plane.position;
        });
    threads.clear();
    EXPECT_EQ(same, 20);
}

TEST(LevelSets, TravelAsAnySurface) {
    const Data data{cube(32)};
    const auto mesh = data.mesh("r", radius);
    const auto lattice = protocol::lattice_over(cube(32).bounds());
    protocol::EncodeOptions options;
    options.final = true;
    const auto state = protocol::encode_state(mesh, lattice, options);
    ASSERT_TRUE(state) << state.error().message;
    protocol::MeshDecoder decoder;
    for (const auto& frame : state->frames)
        ASSERT_TRUE(decoder.fold(*frame));
    const auto& arrived = *decoder.newest()->mesh;
    EXPECT_EQ(arrived.vertices(), mesh.vertices());
    EXPECT_EQ(arrived.cells().size(), mesh.cells.size());
    EXPECT_EQ(decoder.newest()->header.state_sum, state->state_sum);
}

} // namespace
} // namespace wakesurf::server::node_fields_test
