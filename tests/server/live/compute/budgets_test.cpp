// What one person, one link and all links together may use, and what stays for those with the server's token.
#include "server/live/compute/budgets.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wakesurf::server::budgets_test {

namespace {

using std::chrono::milliseconds;

Visitor by_link(const std::string& link, const std::string& person) {
    return {{Role::Viewer, "main", link}, person};
}

Visitor by_token(const std::string& person = {}) {
    return {{}, person};
}

struct BudgetsTest : testing::Test {
    /// How many of `tries` are granted.
    std::size_t taken(const Visitor& who, Use use, std::size_t tries) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < tries; ++i)
            if (auto permit = budgets.take(who, use)) {
                ++count;
                permits.push_back(std::move(*permit));
            }
        return count;
    }

    std::size_t let_through(const Visitor& who, bool edits, std::size_t calls, milliseconds gap) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < calls; ++i, clock.time += gap)
            count += budgets.call(who, edits) ? 0 : 1;
        return count;
    }

    HandClock clock;
    Metrics metrics{clock};
    Budgets budgets{clock, &metrics};
    std::vector<Budgets::Permit> permits;
};

} // namespace

TEST_F(BudgetsTest, CountALongAnswerAsSeveralCallsOfWhoAskedForIt) {
    const Visitor asking = by_link("g1", "a");
    budgets.answered(asking, limits::answer_bytes - 1);
    const auto most = static_cast<std::size_t>(2 * limits::person.calls);
    budgets.answered(asking, (most - 5) * limits::answer_bytes);
    EXPECT_EQ(let_through(asking, false, 10, {}), 5u);
    EXPECT_EQ(let_through(by_link("g1", "b"), false, 10, {}), 10u);
    clock.time += milliseconds(100);
    EXPECT_EQ(let_through(asking, false, most, {}),
              static_cast<std::size_t>(limits::person.calls / 10));
}

TEST_F(BudgetsTest, BoundAPersonALinkAndAllLinksAndKeepTheLastPlacesForHosts) {
    EXPECT_EQ(taken(by_link("g1", "a"), Use::Socket, 1000), limits::person.sockets);
    std::size_t by_first = 0;
    for (int i = 0; i < 20; ++i)
        by_first += taken(by_link("g1", "p" + std::to_string(i)), Use::Socket, 100);
    EXPECT_EQ(by_first, limits::link.sockets - limits::person.sockets);
    std::size_t by_others = 0;
    for (int link = 2; link < 10; ++link)
        for (int i = 0; i < 20; ++i)
            by_others += taken(by_link("g" + std::to_string(link), "p" + std::to_string(i)),
                               Use::Socket, 100);
    const std::size_t by_links = limits::all.sockets - limits::for_hosts.sockets;
    EXPECT_EQ(by_others, by_links - limits::link.sockets);
    EXPECT_EQ(taken(by_token(), Use::Socket, 1000), limits::for_hosts.sockets);
    EXPECT_EQ(budgets.used(Use::Socket), limits::all.sockets);
    EXPECT_EQ(budgets.take(by_link("g1", "a"), Use::Download).has_value(), true)
        << "each kind is counted by itself";
    permits.clear();
    EXPECT_EQ(budgets.used(Use::Socket), 0u);
    EXPECT_EQ(taken(by_link("g1", "a"), Use::Socket, 1000), limits::person.sockets);
}

TEST_F(BudgetsTest, SayWhoseLimitItIsAndWhatToDo) {
    taken(by_link("g1", "a"), Use::Download, 100);
    const auto mine = budgets.take(by_link("g1", "a"), Use::Download);
    ASSERT_FALSE(mine);
    EXPECT_EQ(mine.error().code, core::Error::Code::OverLimit);
    EXPECT_EQ(mine.error().limit, limits::person.downloads);
    EXPECT_EQ(mine.error().message, "you have reached the limit of downloads under way: 8");
    EXPECT_FALSE(mine.error().hint.empty());
    taken(by_link("g1", "b"), Use::Download, 100);
    const auto ours = budgets.take(by_link("g1", "c"), Use::Download);
    ASSERT_FALSE(ours);
    EXPECT_EQ(ours.error().limit, limits::link.downloads);
    EXPECT_NE(metrics.text({}).find(R"(wakesurf_rejected_total{reason="rate_limited"} 186)"),
              std::string::npos)
        << metrics.text({});
}

TEST_F(BudgetsTest, CountWhatTheyRefuseByItsKind) {
    const Visitor person = by_link("g1", "a");
    taken(person, Use::Socket, limits::person.sockets + 3);
    taken(person, Use::Probe, limits::person.probes + 2);
    let_through(person, true, static_cast<std::size_t>(2.0 * limits::person.edits) + 5,
                milliseconds(0));
    let_through(person, false, static_cast<std::size_t>(2.0 * limits::person.calls),
                milliseconds(0));
    budgets.read(person, 2.0 * limits::person.messages + 1.0);
    const std::string text = metrics.text({});
    const auto count = [&](const std::string& kind) {
        const std::string start = "wakesurf_over_budget_total{kind=\"" + kind + "\"} ";
        const auto at = text.find(start);
        return at == std::string::npos ? -1 : std::stoi(text.substr(at + start.size()));
    };
    EXPECT_EQ(count("sockets"), 3);
    EXPECT_EQ(count("probes"), 2);
    EXPECT_EQ(count("edits"), 5);
    EXPECT_EQ(count("calls"), static_cast<int>(2.0 * limits::person.edits));
    EXPECT_EQ(count("messages"), 1);
    EXPECT_EQ(count("downloads"), 0);
}

TEST_F(BudgetsTest, GiveAPlaceBackAlsoAfterTheirEnd) {
    Budgets::Permit permit;
    {
        Budgets ended(clock);
        permit = *ended.take(by_link("g1", "a"), Use::Socket);
    }
    permit.reset();
}

TEST_F(BudgetsTest, GrantABurstOfEditsAndThenSoManyASecondHoweverManySocketsThereAre) {
    const Visitor person = by_link("g1", "a");
    const auto burst = static_cast<std::size_t>(2.0 * limits::person.edits);
    EXPECT_EQ(let_through(person, true, 1000, milliseconds(0)), burst);
    EXPECT_EQ(let_through(by_link("g1", "b"), true, 1000, milliseconds(0)), burst)
        << "others of the link go on";
    clock.time += milliseconds(10);
    EXPECT_EQ(let_through(person, true, 1000, milliseconds(10)), 1000u) << "a hundred a second";
    clock.time += std::chrono::hours(1);
    EXPECT_EQ(let_through(person, true, 1000, milliseconds(0)), burst);
    const auto wait = budgets.call(person, true);
    ASSERT_TRUE(wait);
    EXPECT_EQ(wait->retry_after, milliseconds(5));
    EXPECT_EQ(wait->limit, limits::person.edits);
    EXPECT_FALSE(budgets.call(person, false)) << "readers read when edits are used up";
    clock.time += wait->retry_after;
    EXPECT_FALSE(budgets.call(person, true));
}

TEST_F(BudgetsTest, BoundTheCallsOfALinkHoweverManyPeopleComeByIt) {
    std::size_t calls = 0;
    for (int i = 0; i < 20; ++i)
        calls += let_through(by_link("g1", "p" + std::to_string(i)), false, 5000, milliseconds(0));
    EXPECT_EQ(calls, static_cast<std::size_t>(2.0 * limits::link.calls));
    EXPECT_EQ(let_through(by_link("g2", "p1"), false, 100, milliseconds(0)), 100u);
    EXPECT_EQ(let_through(by_token(), false, 100, milliseconds(0)), 100u);
}

TEST_F(BudgetsTest, NeverHoldUpADragOfThirtyEditsASecond) {
    EXPECT_EQ(let_through(by_link("g1", "a"), true, 1800, milliseconds(33)), 1800u);
}

TEST_F(BudgetsTest, TellHowLongToReadNoFurther) {
    const Visitor person = by_link("g1", "a");
    EXPECT_EQ(budgets.read(person, 2.0 * limits::person.messages).count(), 0);
    EXPECT_EQ(budgets.read(person, limits::person.messages / 10.0), milliseconds(100));
    EXPECT_EQ(budgets.read(by_link("g1", "b"), 1.0).count(), 0);
    clock.time += milliseconds(100);
    EXPECT_EQ(budgets.read(person, 0.0).count(), 0) << "the debt is paid";
}

TEST_F(BudgetsTest, TakeScriptsWithTheServersTokenAsManyAndItsBrowsersEachAsOne) {
    EXPECT_EQ(taken(by_token("192.0.2.1"), Use::Socket, 1000), 1000u);
    EXPECT_EQ(taken(by_token("login 1"), Use::Socket, 1000), limits::person.sockets);
}

TEST_F(BudgetsTest, GiveAllWhoCameByALinkOneTurnInThePool) {
    EXPECT_EQ(Budgets::line(by_link("g1", "a")), Budgets::line(by_link("g1", "b")));
    EXPECT_NE(Budgets::line(by_link("g1", "a")), Budgets::line(by_link("g2", "a")));
    EXPECT_NE(Budgets::line(by_link("g1", "a")), Budgets::line(by_token()));
}

} // namespace wakesurf::server::budgets_test
