// The real job under mpirun: surfaces through bricks from ranks have the bytes of those from files, also when a rank is killed.
#include "core/field/sample_scalar.hpp"
#include "tests/server/data/bricks/bricks_fixture.hpp"
#include "tests/support/brick_store.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/ranks_of_job.hpp"

#include <signal.h>

#include <fstream>
#include <thread>

namespace wakesurf::server::rank_bricks_test {
namespace {

using namespace tests;
using namespace std::chrono_literals;

constexpr auto at_most = 300s; // longer than any machine takes

class RankBricksTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        write_bricks(store());
        reader_ = reader_of(store());
        flat_ = streak_through(reader_, false);
    }

    static void TearDownTestSuite() {
        reader_.reset();
        folder_.reset();
    }

    void SetUp() override {
        if (!std::filesystem::exists(bricks_program()))
            GTEST_SKIP() << "wakesurf-bricks is not built: WAKESURF_MPI is off";
        ASSERT_GT(flat_.cells.size(), 100u);
    }

    static std::filesystem::path store() { return *folder_ / "s"; }

    static RankBricks::Options job(int ranks, const std::vector<std::string>& more = {}) {
        RankBricks::Options options;
        options.words = mpirun(ranks);
        options.words.insert(options.words.end(), more.begin(), more.end());
        options.program = bricks_program();
        options.store = store();
        options.first_rest = 1ms;
        options.patience = options.hung = at_most; // a slow machine changes nothing
        return options;
    }

    /// Without osc ^sm one machine's window is shared memory, whatever carries messages.
    static std::vector<std::string> over_tcp() {
        return {"--mca", "pml", "ob1", "--mca", "btl", "tcp,self", "--mca", "osc", "^sm"};
    }

    /// Reads all until ranks have brought all: they serve while they still read their share.
    static void read_until_held(const RankedStore& source) {
        const auto until = std::chrono::steady_clock::now() + at_most;
        for (std::uint64_t before = 0, now = 0; now - before < bricks_in_all;) {
            ASSERT_LT(std::chrono::steady_clock::now(), until);
            before = source.ranks().status().by_ranks;
            ASSERT_FALSE(all_bricks(*source.bricks()).empty());
            now = source.ranks().status().by_ranks;
        }
    }

    static void expect_the_same(const RankBricks::Options& options) {
        const auto source = std::make_shared<RankedStore>(reader_, options);
        source->ranks().begin();
        ASSERT_TRUE(source->ranks().wait_for_job(1, at_most));
        read_until_held(*source);
        const auto before = source->ranks().status();
        EXPECT_EQ(difference(streak_through(source, true), flat_), "");
        const auto after = source->ranks().status();
        EXPECT_GT(after.by_ranks, before.by_ranks);
        EXPECT_EQ(after.by_files, before.by_files);
        EXPECT_EQ(after.damaged, 0u);
        EXPECT_EQ(after.jobs, 1u);
    }

    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline std::shared_ptr<const store::StoreReader> reader_;
    static inline core::QuadComplex flat_;
};

} // namespace

TEST_F(RankBricksTest, SurfacesFromFilesHaveTheBytesOfWholeTimeSteps) {
    EXPECT_EQ(difference(streak_through(reader_, true), flat_), "");
}

TEST_F(RankBricksTest, SurfacesHaveTheSameBytesFromOneTwoAndFourRanks) {
    for (const int ranks : {1, 2, 4}) {
        SCOPED_TRACE(ranks);
        expect_the_same(job(ranks));
    }
}

TEST_F(RankBricksTest, SurfacesHaveTheSameBytesOverTcp) {
    expect_the_same(job(2, over_tcp()));
}

TEST_F(RankBricksTest, WhatTheRanksHaveNoMemoryForComesFromFiles) {
    RankBricks::Options options = job(2);
    options.memory = 5 * brick_record_bytes(3 * 33 * 33 * 33);
    const auto source = std::make_shared<RankedStore>(reader_, options);
    source->ranks().begin();
    ASSERT_TRUE(source->ranks().wait_for_job(1, at_most));
    EXPECT_EQ(source->ranks().status().held, 10u);
    EXPECT_EQ(all_bricks(*source->bricks()), all_bricks(*reader_->bricks()));
    EXPECT_GE(source->ranks().status().by_files, bricks_in_all - 10);
    EXPECT_EQ(difference(streak_through(source, true), flat_), "");
}

TEST_F(RankBricksTest, ScalarsComeFromFilesWhileRanksHoldTheVelocity) {
    StoreValues what;
    what.grid = core::UniformGrid{{0, 0, 0}, core::Vec3(1), {40, 36, 34}};
    what.values.resize(2);
    for (auto& step : what.values)
        for (const std::size_t components : {3u, 1u}) {
            auto& values = step.emplace_back(components * 40 * 36 * 34);
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = static_cast<float>(i * 7919 % 1009 + step.size());
        }
    const TemporaryFolder folder;
    write_whole_store(folder.path(), what, 32);
    const auto reader = reader_of(folder.path());
    RankBricks::Options options = job(2);
    options.store = folder.path();
    const auto source = std::make_shared<RankedStore>(reader, options);
    source->ranks().begin();
    ASSERT_TRUE(source->ranks().wait_for_job(1, at_most));
    const std::vector<core::Vec3> places{{1, 2, 3}, {20.5, 7.25, 30.1}, {38.5, 34.5, 32.5}};
    const std::vector<double> times(places.size(), 0.25);
    const auto sampled = [&](std::shared_ptr<const core::TimeStepSource> from, bool by_brick) {
        core::TimeStepCache::Options cache;
        cache.by_brick = by_brick;
        const auto flow =
            core::make_stored_flow(std::make_shared<core::TimeStepCache>(std::move(from), cache));
        return core::sample_scalar(*flow, *reader, 0, places, times, {}).value();
    };
    EXPECT_EQ(sampled(source, true), sampled(reader, false));
    EXPECT_EQ(source->ranks().status().by_ranks, 0u);
    EXPECT_GT(source->ranks().status().by_files, 0u);
}

TEST_F(RankBricksTest, AKilledRankCostsNoSurfaceAndTheJobIsStartedAgain) {
    const auto source = std::make_shared<RankedStore>(reader_, job(2));
    source->ranks().begin();
    for (std::uint64_t jobs = 1; jobs <= 2; ++jobs) {
        ASSERT_TRUE(source->ranks().wait_for_job(jobs, at_most));
        read_until_held(*source);
        const auto ranks = ranks_of(store());
        ASSERT_EQ(ranks.size(), 2u);
        std::jthread murderer([&] { ::kill(ranks[jobs % 2], SIGKILL); }); // while it is made
        EXPECT_EQ(difference(streak_through(source, true), flat_), "");
        murderer.join();
        EXPECT_EQ(difference(streak_through(source, true), flat_), "");
    }
    ASSERT_TRUE(source->ranks().wait_for_job(3, at_most));
    read_until_held(*source);
    EXPECT_EQ(difference(streak_through(source, true), flat_), "");
}

TEST_F(RankBricksTest, ARankThatHangsKeepsOnlyItsOwnBricksAndIsAskedAgainWhenItGoesOn) {
    RankBricks::Options options = job(4, over_tcp());
    options.patience = 200ms;
    const auto source = std::make_shared<RankedStore>(reader_, options);
    source->ranks().begin();
    ASSERT_TRUE(source->ranks().wait_for_job(1, at_most));
    read_until_held(*source);
    ::kill(rank_of(store(), 3), SIGSTOP);
    const auto before = source->ranks().status();
    EXPECT_EQ(difference(streak_through(source, true), flat_), "");
    EXPECT_EQ(all_bricks(*source->bricks()), all_bricks(*reader_->bricks()));
    const auto after = source->ranks().status();
    EXPECT_GE(after.by_files - before.by_files, bricks_in_all / 4);
    EXPECT_GT(after.by_ranks, before.by_ranks);
    ::kill(rank_of(store(), 3), SIGCONT);
    read_until_held(*source);
    EXPECT_EQ(source->ranks().status().jobs, 1u);
}

TEST_F(RankBricksTest, AJobIsEndedWithTheRankThatHangsAndStartedAgain) {
    for (const int which : {0, 3}) {
        SCOPED_TRACE(which);
        RankBricks::Options options = job(4, over_tcp());
        options.patience = 200ms;
        options.hung = 1s;
        const auto source = std::make_shared<RankedStore>(reader_, options);
        source->ranks().begin();
        ASSERT_TRUE(source->ranks().wait_for_job(1, at_most));
        const pid_t hangs = rank_of(store(), which);
        ::kill(hangs, SIGSTOP);
        EXPECT_EQ(difference(streak_through(source, true), flat_), "");
        ASSERT_TRUE(source->ranks().wait_for_job(2, at_most));
        const auto until = std::chrono::steady_clock::now() + at_most;
        while (::kill(hangs, 0) == 0) // mpirun ends it in its time
            ASSERT_LT(std::chrono::steady_clock::now(), until);
        read_until_held(*source);
    }
}

TEST_F(RankBricksTest, NoRankOutlivesItsServer) {
    {
        const auto source = std::make_shared<RankedStore>(reader_, job(2));
        source->ranks().begin();
        ASSERT_TRUE(source->ranks().wait_for_job(1, at_most));
        EXPECT_EQ(ranks_of(store()).size(), 2u);
    }
    EXPECT_TRUE(ranks_of(store()).empty());
}

TEST_F(RankBricksTest, ADamagedBrickIsNamedByTheFilesAsWithoutRanks) {
    const auto damaged = *folder_ / "damaged";
    std::filesystem::copy(store(), damaged, std::filesystem::copy_options::recursive);
    {
        std::fstream file(damaged / "velocity_000000.f32",
                          std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(1000);
        file.put('\x55');
    }
    RankBricks::Options options = job(1);
    options.store = damaged;
    const auto reader = reader_of(damaged);
    RankedStore source(reader, options);
    source.ranks().begin();
    ASSERT_TRUE(source.ranks().wait_for_job(1, at_most));
    std::vector<float> room(3 * 33 * 33 * 33);
    const auto outcome = outcomes_of(*source.bricks(), {{0, 0, room}}).front();
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, core::Error::Code::Corrupt);
    EXPECT_NE(outcome.error().message.find("brick 0 of time-step 0"), std::string::npos);
}

} // namespace wakesurf::server::rank_bricks_test
