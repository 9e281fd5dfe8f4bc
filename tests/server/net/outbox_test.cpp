#include "server/limits.hpp"
#include "server/net/outbox.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server {

namespace {

std::shared_ptr<const SurfaceState> state(std::uint32_t epoch, std::size_t frames) {
    auto out = std::make_shared<SurfaceState>();
    out->epoch = epoch;
    for (std::size_t i = 0; i < frames; ++i)
        out->frames.push_back(std::make_shared<const std::vector<std::byte>>(
            1, static_cast<std::byte>(16 * epoch + i)));
    return out;
}

int first_byte(const std::optional<Outbox::Item>& item) {
    const auto* frame = item ? std::get_if<Outbox::Frame>(&*item) : nullptr;
    return frame == nullptr ? -1 : std::to_integer<int>((**frame)[0]);
}

} // namespace

TEST(Outbox, SendsMessagesBeforeFramesAndBothInOrder) {
    Outbox outbox;
    outbox.push(1, state(1, 2));
    ASSERT_TRUE(outbox.push("a"));
    ASSERT_TRUE(outbox.push("b"));
    EXPECT_EQ(std::get<std::string>(*outbox.pop()), "a");
    EXPECT_EQ(std::get<std::string>(*outbox.pop()), "b");
    EXPECT_EQ(first_byte(outbox.pop()), 16);
    EXPECT_EQ(first_byte(outbox.pop()), 17);
    EXPECT_TRUE(outbox.empty());
    EXPECT_FALSE(outbox.pop());
}

TEST(Outbox, KeepsOnlyTheNewestStateOfASurface) {
    Outbox outbox;
    for (std::uint32_t epoch = 1; epoch <= 10; ++epoch)
        outbox.push(1, state(epoch, 3));
    outbox.push(2, state(1, 1));
    EXPECT_EQ(first_byte(outbox.pop()), 160);
    outbox.push(1, state(11, 1)); // the rest of epoch 10 goes as a whole
    EXPECT_EQ(first_byte(outbox.pop()), 16);
    EXPECT_EQ(first_byte(outbox.pop()), 176);
    EXPECT_TRUE(outbox.empty());
}

TEST(Outbox, DropsFramesOfEpochsThatAreOver) {
    Outbox outbox;
    outbox.push(1, state(4, 2));
    outbox.push(2, state(4, 1));
    outbox.drop_frames(1, 4);
    EXPECT_EQ(first_byte(outbox.pop()), 64);
    outbox.drop_frames(1, 5);
    EXPECT_EQ(first_byte(outbox.pop()), 64) << "of surface 2";
    EXPECT_TRUE(outbox.empty());
}

TEST(Outbox, SaysWhenMessagesPileUp) {
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

} // namespace wakesurf::server
