// Level sets by the real process that extracts them, against closed forms; and what becomes of them when it is killed, hangs or lacks memory.
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_surface.hpp"
#include "protocol/wire/mesh_decoder.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "server/data/levels/level_sets.hpp"
#include "server/live/compute/compute_pool.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/mesh_borders.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/scalar_store.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <cstring>
#include <future>
#include <limits>
#include <mutex>
#include <thread>

namespace wakesurf::server::level_sets_test {
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

LevelSets::Options usual() {
    LevelSets::Options options;
    options.process.program = tests::importer_program();
    return options;
}

struct Data {
    explicit Data(const core::Grid& grid,
                  const std::vector<std::pair<std::string, tests::ScalarFormula>>& scalars =
                      {{"r", distance}, {"h", height}},
                  const LevelSets::Options& options = usual(),
                  const std::function<bool(const Vec3&)>& solid = {})
        : store(grid, {0.0, 1.0}, scalars, solid),
          levels(std::make_shared<LevelSets>(store.flow(), store.reader(), "U", options)) {}

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
    std::shared_ptr<const LevelSets> levels;
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
    expect_hole(Data(cube(41), {{"r", distance}}, usual(), [](const Vec3& x) { return x.x > 0.31; })
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
    const auto process = data.levels->process();
    EXPECT_TRUE(data.surface("r", radius));
    EXPECT_EQ(data.levels->process(), process) << "the same process";
}

/// The process that extracts, below the one that watches it.
pid_t extractor_below(pid_t watching) {
    const std::string id = std::to_string(watching);
    return std::stoi(tests::read_file("/proc/" + id + "/task/" + id + "/children"));
}

TEST(LevelSets, OfAProcessThatIsKilledAreExtractedByANewOne) {
    const Data data{cube(16)};
    const auto before = data.mesh("r", radius);
    const auto process = data.levels->process();
    ::kill(extractor_below(*process), SIGKILL);
    EXPECT_EQ(data.mesh("r", radius).position, before.position);
    EXPECT_NE(data.levels->process(), process);
}

TEST(LevelSets, OfProcessesThatEndEachTimeAreAnError) {
    auto options = usual();
    options.process.program = "/bin/sleep"; // takes none of these arguments: ends at once
    EXPECT_NE(Data(cube(9), {{"r", distance}}, options)
                  .surface("r", radius)
                  .error()
                  .message.find("ended"),
              std::string::npos);
}

/// A process that never answers.
LevelSets::Options hanging(const tests::TemporaryFolder& folder) {
    auto options = usual();
    options.process.program = folder / "hangs";
    tests::write_file(options.process.program, "#!/bin/sh\nexec sleep 600\n");
    std::filesystem::permissions(options.process.program, std::filesystem::perms::owner_all);
    return options;
}

TEST(LevelSets, OfAProcessThatHangsAreAnErrorAndTheNextOnesAreExtracted) {
    const tests::TemporaryFolder folder;
    auto options = hanging(folder);
    options.process.patience = std::chrono::milliseconds(100);
    EXPECT_NE(Data(cube(9), {{"r", distance}}, options)
                  .surface("r", radius)
                  .error()
                  .message.find("does not answer"),
              std::string::npos);
}

TEST(LevelSets, OfAProcessThatIsStoppedAreAnErrorOnceAndTheNextOnesAreExtracted) {
    auto options = usual();
    options.process.patience = std::chrono::milliseconds(300);
    const Data data{cube(16), {{"r", distance}}, options};
    const auto before = data.mesh("r", radius);
    ::kill(extractor_below(*data.levels->process()), SIGSTOP);
    const auto failed = data.surface("r", radius);
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().message.find("does not answer"), std::string::npos);
    EXPECT_EQ(data.mesh("r", radius).position, before.position);
}

TEST(LevelSets, OfAProcessThatIsAtWorkAreWaitedForBeyondThePatienceAndNotBeyondTheLongestTime) {
    const tests::TemporaryFolder folder;
    auto options = usual();
    options.process.program = folder / "works"; // in a child, as the extractor is
    tests::write_file(options.process.program,
                      "#!/bin/sh\nsh -c 'while kill -0 $PPID 2>/dev/null; do :; done' &\nwait\n");
    std::filesystem::permissions(options.process.program, std::filesystem::perms::owner_all);
    options.process.patience = std::chrono::milliseconds(100);
    options.process.longest = std::chrono::milliseconds(1000);
    const auto begun = std::chrono::steady_clock::now();
    const auto failed = Data(cube(9), {{"r", distance}}, options).surface("r", radius);
    ASSERT_FALSE(failed);
    EXPECT_GE(std::chrono::steady_clock::now() - begun, options.process.longest);
}

TEST(LevelSets, OfAProcessThatHangsKeepNoPlaceOfTheComputePoolFromOtherSessions) {
    const tests::TemporaryFolder folder;
    const Data data{cube(9), {{"r", distance}}, hanging(folder)};
    std::stop_source stop;
    ComputePool pool(2);
    for (int i = 0; i < 8; ++i)
        pool.run("level" + std::to_string(i), PriorityClass::Long, [&] {
            (void)data.levels->extract({"r", radius, 0.0, 1'000'000}, stop.get_token());
        });
    std::promise<void> ninth;
    pool.run("stream", PriorityClass::Long, [&] { ninth.set_value(); });
    EXPECT_EQ(ninth.get_future().wait_for(std::chrono::seconds(10)), std::future_status::ready);
    stop.request_stop();
}

TEST(LevelSets, AreAskedForInTheOrderOfTheCallers) {
    const tests::TemporaryFolder folder;
    auto options = usual();
    options.process.program =
        folder / "notes"; // the first one hangs, the others note what they are asked
    const std::string notes = (folder / "requests").string();
    const std::string read = "head -c " + std::to_string(sizeof(importer::LevelRequest));
    tests::write_file(options.process.program,
                      "#!/bin/sh\nif mkdir " + notes + ".first 2>/dev/null; then\n" + read +
                          " > /dev/null\nmkdir " + notes + ".asked\nexec sleep 600\nfi\n" + read +
                          " >> " + notes + "\nhead -c 1000 /dev/zero\n");
    std::filesystem::permissions(options.process.program, std::filesystem::perms::owner_all);
    options.process.patience = std::chrono::milliseconds(300);
    const Data data{cube(9), {{"r", distance}}, options};
    std::stop_source first;
    std::vector<std::jthread> threads;
    for (std::uint64_t i = 0; i < 6; ++i) {
        threads.emplace_back([&, i] {
            (void)data.levels->extract({"r", radius, 0.0, i},
                                       i == 0 ? first.get_token() : std::stop_token());
        });
        while (data.levels->asking() <= i)
            std::this_thread::yield();
    }
    while (!std::filesystem::exists(notes + ".asked"))
        std::this_thread::yield();
    first.request_stop();
    threads.clear();
    const std::string text = tests::read_file(notes);
    std::vector<std::uint64_t> order(text.size() / sizeof(importer::LevelRequest));
    for (std::size_t i = 0; i < order.size(); ++i) {
        importer::LevelRequest request;
        std::memcpy(&request, text.data() + i * sizeof(request), sizeof(request));
        order[i] = request.most_triangles;
    }
    EXPECT_EQ(order, (std::vector<std::uint64_t>{1, 2, 3, 4, 5}));
}

TEST(LevelSets, OfAProcessThatAnswersNonsenseAreAnError) {
    tests::TemporaryFolder folder;
    auto options = usual();
    options.process.program = folder / "lies";
    tests::write_file(options.process.program,
                      "#!/bin/sh\nhead -c 4000000 /dev/zero\nexec sleep 600\n");
    std::filesystem::permissions(options.process.program, std::filesystem::perms::owner_all);
    EXPECT_NE(Data(cube(9), {{"r", distance}}, options)
                  .surface("r", radius)
                  .error()
                  .message.find("answered what is none"),
              std::string::npos);
}

TEST(LevelSets, GivenUpWhileTheProcessIsAtWorkAreNotTheAnswerToTheNext) {
    const Data data{cube(16)};
    const auto before = data.mesh("h", 0.25);
    std::stop_source stop;
    stop.request_stop();
    for (int i = 0; i < 5; ++i)
        (void)data.levels->extract({"r", radius, 0.0, 1'000'000}, stop.get_token());
    EXPECT_EQ(data.mesh("h", 0.25).position, before.position);
}

TEST(LevelSets, KeepTheProcessWhileItIsUsedAndEndItWhenNoOneAsks) {
    HandClock clock;
    auto options = usual();
    options.clock = &clock;
    options.idle = std::chrono::seconds(30);
    const Data data(cube(16), {{"r", distance}}, options);
    EXPECT_FALSE(data.levels->process());
    (void)data.mesh("r", radius);
    const auto process = data.levels->process();
    ASSERT_TRUE(process);
    clock.time += std::chrono::seconds(29);
    EXPECT_FALSE(data.levels->take_idle());
    (void)data.mesh("r", 0.5);
    EXPECT_EQ(data.levels->process(), process);
    clock.time += std::chrono::seconds(31);
    EXPECT_TRUE(data.levels->take_idle());
    EXPECT_FALSE(data.levels->process());
    EXPECT_NE(::kill(*process, 0), 0) << "it has ended";
    expect_sphere(data.mesh("r", radius), 2.0 / 15);
}

TEST(LevelSets, CountTheirMemoryAndGiveItBackWhenOthersNeedIt) {
    const core::MemoryAccount account(std::size_t{1} << 30);
    auto options = usual();
    options.account = account;
    const Data data(cube(16), {{"r", distance}}, options);
    EXPECT_EQ(account.used(core::MemoryUse::Importers), 0u);
    (void)data.mesh("r", radius);
    EXPECT_GT(account.used(core::MemoryUse::Importers), std::size_t{16} << 20);
    account.make_room(account.budget());
    EXPECT_EQ(account.used(core::MemoryUse::Importers), 0u);
    EXPECT_FALSE(data.levels->process());
    expect_sphere(data.mesh("r", radius), 2.0 / 15);

    const core::MemoryAccount little(std::size_t{8} << 20);
    options.account = little;
    EXPECT_EQ(Data(cube(16), {{"r", distance}}, options).surface("r", radius).error().code,
              Error::Code::OverLimit);
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
} // namespace wakesurf::server::level_sets_test
