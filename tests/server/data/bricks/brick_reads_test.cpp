// How long a read waits for a job, and a job may keep silent, by a clock that the test turns.
#include "server/data/bricks/brick_reads.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::brick_reads_test {
namespace {

using namespace std::chrono_literals;

class ReadsOnTheirWayTest : public testing::Test {
  protected:
    ReadsOnTheirWayTest() { options.clock = &clock; }

    /// Asks for a brick whose number is that of its slot.
    void ask(std::uint32_t slot) {
        auto asked = std::make_shared<AskedReads>();
        asked->reads.push_back({0, slot, {}});
        reads.add(std::vector{slot}, {{std::move(asked), 0}});
    }

    static std::vector<std::size_t> bricks(const std::vector<WaitingRead>& which) {
        std::vector<std::size_t> out;
        for (const WaitingRead& each : which)
            out.push_back(each.read().brick);
        return out;
    }

    using Bricks = std::vector<std::size_t>;

    HandClock clock;
    RankOptions options;
    ReadsOnTheirWay reads{options};
};

} // namespace

TEST_F(ReadsOnTheirWayTest, AReadIsLateWhenItsOwnPatienceIsOver) {
    ask(3);
    EXPECT_EQ(reads.due(), clock.time + options.patience);
    clock.time += options.patience / 2;
    ask(5);
    clock.time += options.patience / 2 - 1ms;
    EXPECT_EQ(bricks(reads.late()), Bricks{});
    clock.time += 1ms;
    EXPECT_EQ(bricks(reads.late()), Bricks{3});
    EXPECT_EQ(bricks(reads.late()), Bricks{}) << "told once";
    EXPECT_FALSE(reads.nobody_waits());
    EXPECT_EQ(bricks(reads.end()), Bricks{5});
}

TEST_F(ReadsOnTheirWayTest, AnAnswerThatComesTooLateIsForNobody) {
    ask(3);
    clock.time += options.patience;
    EXPECT_EQ(bricks(reads.late()), Bricks{3});
    EXPECT_TRUE(reads.nobody_waits());
    EXPECT_FALSE(reads.take(3).has_value());
    ask(3);
    EXPECT_EQ(reads.take(3)->read().brick, 3u);
}

TEST_F(ReadsOnTheirWayTest, AJobHangsThatAnswersAllButOne) {
    ask(1);
    for (int i = 0; i < 9; ++i) {
        clock.time += options.hung / 10;
        ask(2);
        EXPECT_TRUE(reads.take(2));
        EXPECT_FALSE(reads.hung());
    }
    clock.time += options.hung / 10;
    EXPECT_TRUE(reads.hung());
}

TEST_F(ReadsOnTheirWayTest, AJobThatOwesNothingNeverHangs) {
    ask(1);
    EXPECT_TRUE(reads.take(1));
    clock.time += 10 * options.hung;
    EXPECT_FALSE(reads.hung());
    EXPECT_EQ(reads.due(), ReadsOnTheirWay::Time::max());
    ask(1);
    clock.time += options.hung - 1ms;
    EXPECT_FALSE(reads.hung());
    clock.time += 1ms;
    EXPECT_TRUE(reads.hung());
}

} // namespace wakesurf::server::brick_reads_test
