// What waits for all clients together: bounded however many do not read, and a little is always for each.
#include "server/base/limits.hpp"
#include "server/net/outbox.hpp"

#include <gtest/gtest.h>

#include <list>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server::outbox_memory_test {

namespace {

constexpr std::size_t budget = std::size_t{160} << 20;
constexpr std::size_t all = budget / limits::outboxes_part;
constexpr std::size_t kibi = 1024;

struct OutboxMemoryTest : testing::Test {
    core::MemoryAccount account{budget};
    OutboxMemory memory{account};
};

} // namespace

TEST_F(OutboxMemoryTest, LetsOneWhoDoesNotReadHaveAFifth) {
    OutboxMemory::Share one(&memory);
    std::size_t bytes = 0;
    while (one.grow(kibi))
        bytes += kibi;
    EXPECT_NEAR(static_cast<double>(bytes), all / 5.0, 2.0 * kibi);
    EXPECT_EQ(memory.bytes(), bytes);
    EXPECT_NEAR(static_cast<double>(account.used(core::MemoryUse::Messages)),
                static_cast<double>(bytes), 256.0 * kibi);
}

TEST_F(OutboxMemoryTest, IsBoundedHoweverManyDoNotReadAndLeavesALittleForEach) {
    constexpr std::size_t many = 2048;
    std::list<OutboxMemory::Share> shares;
    for (std::size_t i = 0; i < many; ++i) {
        auto& share = shares.emplace_back(&memory);
        while (share.grow(4 * kibi)) {
        }
    }
    EXPECT_LE(memory.bytes(), all + many * limits::outbox_small_bytes);
    OutboxMemory::Share light(&memory);
    EXPECT_TRUE(light.grow(limits::outbox_small_bytes));
    EXPECT_FALSE(light.grow(1));
    EXPECT_EQ(memory.hold(std::size_t{1} << 20), nullptr);
    shares.clear();
    EXPECT_NE(memory.hold(std::size_t{1} << 20), nullptr);
    EXPECT_EQ(memory.bytes(), limits::outbox_small_bytes) << "what was held is given back";
}

TEST_F(OutboxMemoryTest, CountsATextThatWaitsForManyAboutOnce) {
    std::list<Outbox> outboxes;
    const auto text = std::make_shared<const std::string>(std::string(256 * kibi, 't'));
    for (int i = 0; i < 1500; ++i)
        ASSERT_TRUE(outboxes.emplace_back(&memory).push(text)) << i;
    EXPECT_LT(memory.bytes(), 10 * text->size());
}

TEST_F(OutboxMemoryTest, HasAMessageUntilItHasBeenSent) {
    Outbox outbox(&memory);
    ASSERT_TRUE(outbox.push(std::string(kibi, 'a')));
    ASSERT_TRUE(outbox.push(std::string(kibi, 'b')));
    ASSERT_TRUE(outbox.pop());
    EXPECT_EQ(memory.bytes(), 2 * kibi) << "it is being written";
    outbox.sent();
    EXPECT_EQ(memory.bytes(), kibi);
}

} // namespace wakesurf::server::outbox_memory_test
