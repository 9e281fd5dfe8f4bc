// Turns to write, by hand.
#include "server/net/net_services.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wakesurf::server::write_turns_test {

namespace {

class WriteTurnsTest : public testing::Test {
  protected:
    struct Named final : WriteScheduler::Writer {
        Named(WriteTurnsTest& in, std::string called) : test(in), name(std::move(called)) {}

        void write_turn() override {
            test.order.push_back(name);
            test.clock.time += test.cost;
            if (more-- > 0)
                test.turns.ask(me);
        }

        WriteTurnsTest& test;
        std::string name;
        std::weak_ptr<Writer> me;
        int more = 0; ///< turns it asks for when it has one
    };

    std::shared_ptr<Named> writer(const std::string& name) {
        auto made = std::make_shared<Named>(*this, name);
        made->me = made;
        return made;
    }

    /// Runs the task at the front of the loop.
    bool step() {
        if (tasks.empty())
            return false;
        const auto task = std::move(tasks.front());
        tasks.pop_front();
        task();
        return true;
    }

    std::deque<std::function<void()>> tasks;
    HandClock clock;
    WriteScheduler turns{[this](std::function<void()> task) { tasks.push_back(std::move(task)); },
                         clock};
    std::vector<std::string> order;
    std::chrono::milliseconds cost{0}; ///< of a turn
};

} // namespace

TEST_F(WriteTurnsTest, LetOtherEventsInBetweenAFewWritersAndAFewMore) {
    std::vector<std::shared_ptr<Named>> writers;
    for (std::size_t i = 0; i < 3 * WriteScheduler::at_once; ++i)
        turns.ask(writers.emplace_back(writer("w")));
    tasks.emplace_back([this] { order.emplace_back("event"); });
    while (step()) {
    }
    ASSERT_EQ(order.size(), 3 * WriteScheduler::at_once + 1);
    EXPECT_EQ(order[WriteScheduler::at_once], "event");
}

TEST_F(WriteTurnsTest, GetAsMuchTimeAsTheEventsBetweenThem) {
    std::vector<std::shared_ptr<Named>> writers;
    for (std::size_t i = 0; i < 10 * WriteScheduler::at_once; ++i)
        turns.ask(writers.emplace_back(writer("w")));
    cost = std::chrono::milliseconds(1);
    step();
    EXPECT_EQ(order.size(), WriteScheduler::at_once);
    clock.time += std::chrono::milliseconds(40); // something large came in between
    step();
    EXPECT_EQ(order.size(), 4 * WriteScheduler::at_once);
    step();
    EXPECT_EQ(order.size(), 5 * WriteScheduler::at_once);
}

TEST_F(WriteTurnsTest, WriteOnlyWhenTheEventThatAskedIsOver) {
    const auto one = writer("w");
    turns.ask(one);
    EXPECT_TRUE(order.empty());
    step();
    EXPECT_EQ(order, (std::vector<std::string>{"w"}));
}

TEST_F(WriteTurnsTest, PutWhoHasMoreToWriteBehindTheOthers) {
    const auto first = writer("first"), second = writer("second");
    first->more = 2;
    turns.ask(first);
    turns.ask(second);
    while (step()) {
    }
    EXPECT_EQ(order, (std::vector<std::string>{"first", "second", "first", "first"}));
}

TEST_F(WriteTurnsTest, PassOverWhoHasGone) {
    auto gone = writer("gone");
    const auto stays = writer("stays");
    turns.ask(gone);
    turns.ask(stays);
    gone.reset();
    while (step()) {
    }
    EXPECT_EQ(order, (std::vector<std::string>{"stays"}));
}

} // namespace wakesurf::server::write_turns_test
