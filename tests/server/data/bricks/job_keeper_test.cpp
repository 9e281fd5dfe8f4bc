// When a job is started, waited for, given up and started again, by a clock that the test turns.
#include "server/data/bricks/bricks_job.hpp"
#include "tests/server/data/bricks/fake_job.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace wakesurf::server::job_keeper_test {
namespace {

using namespace tests;
using namespace std::chrono_literals;

class JobKeeperTest : public testing::Test {
  protected:
    JobKeeperTest() {
        hello.shape = wanted.shape = {{2, 2, 2}, 32, 1, 24};
        hello.ranks = 1;
        wanted.contradicts = [](std::string_view) { return false; };
        options.words = {"/no/such/program"};
        options.program = "wakesurf-bricks";
        options.store = "store";
        options.clock = &clock;
    }

    /// What becomes of the job that is there or is started now.
    core::Result<bool> outcome(JobKeeper& keeper) {
        for (;;)
            if (auto came = keeper.tend(); !came || *came)
                return came;
    }

    JobHello hello;
    WantedJob wanted;
    RankOptions options;
    HandClock clock;
};

} // namespace

TEST_F(JobKeeperTest, RestsTwiceAsLongAfterEachFailureUpToTheLongestRest) {
    JobKeeper keeper(options, wanted);
    std::vector<std::chrono::nanoseconds> rests;
    for (int i = 0; i < 8; ++i) {
        ASSERT_FALSE(keeper.tend().has_value());
        keeper.end();
        const auto due = keeper.due();
        rests.emplace_back(due - clock.time);
        clock.time = due - 1ms;
        ASSERT_TRUE(keeper.tend().has_value()); // nothing is tried before
        clock.time = due;
    }
    EXPECT_EQ(rests, (std::vector<std::chrono::nanoseconds>{1s, 2s, 4s, 8s, 16s, 32s, 60s, 60s}));
}

TEST_F(JobKeeperTest, RestsShortAgainAfterAJobThatWasThere) {
    JobKeeper keeper(options, wanted);
    for (int i = 0; i < 5; ++i) {
        ASSERT_FALSE(keeper.tend().has_value());
        keeper.end();
        clock.time = keeper.due();
    }
    options.words = fake_job("closes after the greeting", hello, "marks");
    const auto came = outcome(keeper);
    ASSERT_TRUE(came.has_value()) << came.error().message;
    ASSERT_NE(keeper.talk(), nullptr);
    keeper.end();
    EXPECT_EQ(keeper.talk(), nullptr);
    EXPECT_EQ(keeper.due() - clock.time, options.first_rest);
}

TEST_F(JobKeeperTest, WaitsForAJobToComeForAWhileAndNoLonger) {
    options.words = {"/bin/sh", "-c", "exec /bin/sleep 1000"};
    JobKeeper keeper(options, wanted);
    ASSERT_TRUE(keeper.tend().has_value());
    EXPECT_EQ(keeper.due(), clock.time + options.coming);
    clock.time += options.coming - 1ms;
    EXPECT_TRUE(keeper.tend().has_value());
    clock.time += 1ms;
    const auto late = keeper.tend();
    ASSERT_FALSE(late.has_value());
    EXPECT_EQ(late.error().message, "the job has not connected in time");
}

TEST_F(JobKeeperTest, NoticesAtOnceWhenAJobEndsBeforeItIsThere) {
    options.words = {"/bin/false"};
    JobKeeper keeper(options, wanted);
    const auto gone = outcome(keeper);
    ASSERT_FALSE(gone.has_value());
    EXPECT_EQ(gone.error().message, "the job ended before it connected");
}

} // namespace wakesurf::server::job_keeper_test
