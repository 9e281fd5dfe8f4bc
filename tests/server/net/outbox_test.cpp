#include "server/base/limits.hpp"
#include "server/net/outbox.hpp"
#include "tests/server/live/sample_updates.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::outbox_test {

namespace {

class OutboxTest : public testing::Test {
  protected:
    std::shared_ptr<UpdateRing> ring(std::uint32_t number) {
        auto made = std::make_shared<UpdateRing>(number, clock, [] {});
        made->begin(1);
        return made;
    }

    void follow(const std::shared_ptr<UpdateRing>& ring) {
        outbox.follow(FrameCursor(ring, {}, [this](bool behind) {
            ASSERT_TRUE(outbox.push(behind ? "behind" : "caught up"));
        }));
    }

    /// A message, or `SEQ.FRAME`.
    std::string pop() {
        const auto item = outbox.pop();
        if (!item)
            return "";
        if (const auto* text = std::get_if<Outbox::Message>(&*item))
            return **text;
        const Seen frame = seen(std::get<Outbox::Frame>(*item));
        return std::to_string(frame.seq) + "." + std::to_string(frame.frame);
    }

    HandClock clock;
    Outbox outbox;
};

} // namespace

TEST_F(OutboxTest, SendsMessagesBeforeFramesAndBothInOrder) {
    const auto surface = ring(1);
    surface->add(make_update({1, 0, true, 2}));
    follow(surface);
    ASSERT_TRUE(outbox.push("a"));
    EXPECT_EQ(pop(), "a");
    EXPECT_EQ(pop(), "0.0");
    ASSERT_TRUE(outbox.push("b"));
    EXPECT_EQ(pop(), "b") << "no answer waits for a large mesh";
    EXPECT_EQ(pop(), "0.1");
    EXPECT_EQ(pop(), "");
}

TEST_F(OutboxTest, GivesSurfacesTurnsFrameByFrame) {
    const auto large = ring(1), small = ring(9);
    large->add(make_update({1, 0, true, 4}));
    small->add(make_update({1, 5, true, 1}));
    follow(large);
    follow(small);
    EXPECT_EQ(pop(), "0.0");
    EXPECT_EQ(pop(), "5.0");
    small->add(make_update({1, 6, false, 1}));
    EXPECT_EQ(pop(), "0.1");
    EXPECT_EQ(pop(), "6.0");
    EXPECT_EQ(pop(), "0.2");
    EXPECT_EQ(pop(), "0.3");
    EXPECT_EQ(pop(), "");
}

TEST_F(OutboxTest, SendsWhatACursorHasToSayWithoutWaitingForAFrame) {
    const auto surface = ring(1);
    surface->add(make_update({1, 0, true}));
    follow(surface);
    EXPECT_EQ(pop(), "0.0");
    surface->add(make_update({1, 1, false, 1, limits::behind_bytes}));
    surface->add(make_update({1, 2, false}));
    EXPECT_EQ(pop(), "behind");
    EXPECT_EQ(pop(), "");
    surface->add_key(make_update({1, 2, true}));
    EXPECT_EQ(pop(), "2.0");
    EXPECT_EQ(pop(), "caught up");
}

TEST_F(OutboxTest, ForgetsSubscriptionsThatEndAndSurfacesThatGo) {
    const auto one = ring(1), two = ring(2);
    follow(one);
    follow(two);
    one->add(make_update({1, 0, true}));
    two->add(make_update({1, 0, true}));
    EXPECT_TRUE(outbox.unfollow(1));
    EXPECT_FALSE(outbox.unfollow(1));
    two->close();
    EXPECT_EQ(pop(), "");
    EXPECT_EQ(outbox.cursor(1), nullptr);
}

TEST_F(OutboxTest, HasRoomForAsManySubscriptionsAsAreAllowedAtATime) {
    std::vector<std::shared_ptr<UpdateRing>> rings;
    for (std::uint32_t number = 0; number < limits::subscriptions; ++number) {
        ASSERT_TRUE(outbox.may_follow(number));
        follow(rings.emplace_back(ring(number)));
    }
    EXPECT_TRUE(outbox.may_follow(3)) << "once more for the same surface";
    EXPECT_FALSE(outbox.may_follow(limits::subscriptions));
    rings.front()->close();
    EXPECT_TRUE(outbox.may_follow(limits::subscriptions));
}

TEST_F(OutboxTest, SaysWhenMessagesPileUp) {
    Outbox many;
    for (std::size_t i = 0; i < limits::outbox_messages; ++i)
        ASSERT_TRUE(many.push("x"));
    EXPECT_FALSE(many.push("x"));
    Outbox large;
    EXPECT_TRUE(large.push(std::string(limits::outbox_message_bytes, 'x')));
    EXPECT_FALSE(large.push("x"));
    EXPECT_TRUE(large.pop());
    EXPECT_TRUE(large.push("x"));
}

} // namespace wakesurf::server::outbox_test
