// Logins beyond a restart: those of one life of the server, shown to the next.
#include "server/base/private_file.hpp"
#include "server/base/write_behind_file.hpp"
#include "server/net/gate.hpp"
#include "server/net/logins.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server::logins_test {

namespace {

using wakesurf::tests::TemporaryFolder;
namespace fs = std::filesystem;

const std::string token(64, 'a');
constexpr std::int64_t day = 24 * 3600;

/// A server's life: what knows logins, on one folder.
struct Life {
    Life(const fs::path& folder, HandClock& clock, const std::int64_t& wall, std::string secret)
        : loop(clock), grants({loop, clock, entropy, [&wall] { return wall; }}),
          kept(*Logins::open(
              folder,
              entropy,
              [this, folder](Logins::To to, const std::string& text, const Logins::Done& done) {
                  ++writes;
                  bytes += text.size();
                  const auto write =
                      to == Logins::To::Append ? append_private_file : write_private_file;
                  done(to_disk ? write(folder / Logins::ended_name, text) : core::Result<void>());
              },
              [&wall] { return wall; })),
          gate({std::move(secret), "127.0.0.1", 8080, {}, false, &kept, [&wall] { return wall; }},
               entropy,
               clock,
               grants) {}

    int writes = 0;
    std::size_t bytes = 0;
    bool to_disk = true;
    SystemEntropy entropy;
    HandLoop loop;
    Grants grants;
    Logins kept;
    Gate gate;
};

class KeptLoginsTest : public testing::Test {
  protected:
    void start(const std::string& secret = token) {
        life.reset();
        life.emplace(folder.path(), clock, wall, secret);
    }

    void pass(std::int64_t seconds) {
        wall += seconds;
        clock.time += std::chrono::seconds(seconds);
    }

    static HttpRequest with(const std::string& login) {
        HttpRequest out;
        out.method = "POST";
        out.headers = {{"host", "localhost:8080"}, {"authorization", "Bearer " + login}};
        return out;
    }

    std::string login(const std::string& secret = token, std::optional<std::string> had = {}) {
        const auto made = life->gate.login({}, {secret, std::move(had)});
        return made ? made->login : "refused";
    }

    bool good(const std::string& login) { return life->gate.check(with(login)).has_value(); }

    /// Whether there was one to end; it has been written.
    bool log_out(const std::string& login) {
        bool kept = false;
        const auto person = life->gate.logout(
            with(login), [&](const core::Result<void>& done) { kept = done.has_value(); });
        EXPECT_TRUE(kept);
        return !person.empty();
    }

    TemporaryFolder folder;
    HandClock clock;
    std::int64_t wall = 1'700'000'000;
    std::optional<Life> life;
};

} // namespace

TEST_F(KeptLoginsTest, LastThroughRestartsOfTheServer) {
    start();
    const std::string mine = login();
    ASSERT_TRUE(good(mine));
    const std::string person = life->gate.check(with(mine))->person;
    for (int restart = 0; restart < 3; ++restart) {
        pass(60);
        start();
        EXPECT_TRUE(good(mine)) << restart;
        EXPECT_EQ(life->gate.check(with(mine))->person, person);
    }
}

TEST_F(KeptLoginsTest, EndWithTheTokenTheyWereMadeFor) {
    start();
    const std::string mine = login();
    const std::string other_token(64, 'b');
    start(other_token);
    EXPECT_FALSE(good(mine));
    EXPECT_EQ(login(token), "refused");
    EXPECT_TRUE(good(login(other_token)));
}

TEST_F(KeptLoginsTest, AreOnlyThoseThatThisFoldersKeyHasSigned) {
    start();
    const std::string mine = login();
    for (std::size_t i = 0; i < mine.size(); ++i) {
        std::string forged = mine;
        forged[i] = forged[i] == '0' ? '1' : '0';
        EXPECT_FALSE(good(forged)) << forged;
    }
    EXPECT_TRUE(good(mine));
    const TemporaryFolder elsewhere;
    life.emplace(elsewhere.path(), clock, wall, token);
    EXPECT_FALSE(good(mine));
    EXPECT_EQ(fs::status(folder.path() / "login-key").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(KeptLoginsTest, StayEndedWhereTheirBrowserHasLoggedOut) {
    start();
    const std::string mine = login();
    const std::string other = login();
    EXPECT_TRUE(log_out(mine));
    pass(1);
    start();
    EXPECT_FALSE(good(mine));
    EXPECT_TRUE(good(other));
    EXPECT_FALSE(log_out(mine));
    EXPECT_TRUE(log_out(other));
    EXPECT_FALSE(good(other)) << "one of an earlier life";
    start();
    EXPECT_FALSE(good(other));
    EXPECT_EQ(fs::status(folder.path() / "ended-logins").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(KeptLoginsTest, AreOverAMonthAfterTheyWereMadeHoweverManyRestartsThereWere) {
    start();
    std::string mine = login();
    for (int i = 1; i < 30; ++i) {
        pass(day);
        start();
        mine = login(token, mine);
        EXPECT_TRUE(good(mine)) << i;
    }
    pass(day);
    EXPECT_FALSE(good(mine));
    start();
    EXPECT_FALSE(good(mine));
}

TEST_F(KeptLoginsTest, AreOverAWeekAfterTheyWereRenewedAndNothingHasToBeWrittenForThat) {
    start();
    std::vector<std::string> many;
    for (int i = 0; i < 4072; ++i)
        many.push_back(login());
    pass(60);
    start();
    EXPECT_TRUE(good(many.front()));
    pass(7 * day);
    EXPECT_TRUE(good(login()));
    for (const std::string& each : many)
        EXPECT_FALSE(good(each));
    EXPECT_EQ(life->writes, 0);
    start();
    EXPECT_FALSE(good(many.front()));
    EXPECT_FALSE(fs::exists(folder.path() / "ended-logins"));
}

TEST_F(KeptLoginsTest, StayEndedAlsoWhereTheClockGoesBack) {
    start();
    const std::string mine = login();
    pass(8 * day);
    EXPECT_TRUE(log_out(mine)) << "too old, and not to come back";
    pass(-8 * day);
    EXPECT_FALSE(good(mine));
}

TEST_F(KeptLoginsTest, OfAShareLinkEndWithItAndAreNotThoseOfAnotherOfItsName) {
    start();
    const auto link = life->grants.make("main", Role::Viewer, {});
    ASSERT_TRUE(link);
    const std::string mine = login(link->key);
    EXPECT_TRUE(good(mine));
    start(); // whose journal has no such link
    EXPECT_FALSE(good(mine));
    const auto again = life->grants.make("main", Role::Host, {});
    ASSERT_TRUE(again);
    EXPECT_EQ(again->grant.id, link->grant.id) << "else this shows nothing";
    EXPECT_FALSE(good(mine));
}

TEST_F(KeptLoginsTest, AreEndedOneByOneSoThatOneWhoLogsOutOftenEndsNoOthers) {
    start();
    const auto link = life->grants.make("main", Role::Viewer, {});
    const std::string host = login();
    const std::string out = login();
    const std::string stays = login(link->key);
    ASSERT_TRUE(log_out(out));
    life->to_disk = false;
    for (std::size_t i = 0; i < Logins::most_ended + 10; ++i)
        life->kept.end({std::to_string(i), wall + static_cast<std::int64_t>(i), 0, link->grant.id},
                       [](const core::Result<void>&) {});
    EXPECT_TRUE(good(host));
    EXPECT_TRUE(good(stays));
    EXPECT_FALSE(good(out)) << "another link's logouts take no room of the token's";
    EXPECT_FALSE(life->kept.ended(link->grant.id, "0")) << "first the oldest";
    EXPECT_TRUE(life->kept.ended(link->grant.id, "5000"));
    life->to_disk = true;
    pass(31 * day);
    EXPECT_TRUE(log_out(login()));
    EXPECT_LT(fs::file_size(folder.path() / "ended-logins"), 100u) << "the others are too old";
}

TEST_F(KeptLoginsTest, AreWrittenOneByOneHoweverManyHaveEnded) {
    start();
    const auto end = [this](std::size_t i) {
        life->kept.end({std::string(28, 'x') + std::to_string(1000 + i), wall, 0, "link"},
                       [](const core::Result<void>& done) { EXPECT_TRUE(done); });
    };
    life->to_disk = false; // a sync each takes long
    for (std::size_t i = 0; i < Logins::most_ended; ++i)
        end(i);
    life->to_disk = true;
    const std::size_t before = life->bytes;
    constexpr std::size_t more = 20;
    for (std::size_t i = 0; i < more; ++i)
        end(Logins::most_ended + i);
    EXPECT_LT(life->bytes - before, more * 100);
    life->to_disk = false;
    for (std::size_t i = 0; i < 3 * Logins::most_ended; ++i)
        end(2 * Logins::most_ended + i);
    EXPECT_LT(life->bytes / static_cast<std::size_t>(life->writes), 200u)
        << "the whole of them is written seldom";
}

TEST_F(KeptLoginsTest, StayEndedWhereTheLastLineOfTheFileIsTornAndMoreEnd) {
    start();
    const std::string first = login(), second = login();
    EXPECT_TRUE(log_out(first));
    std::ofstream(folder.path() / "ended-logins", std::ios::app) << "- 0123456789abcdef 17";
    start();
    EXPECT_TRUE(log_out(second));
    start();
    EXPECT_FALSE(good(first));
    EXPECT_FALSE(good(second));
}

TEST_F(KeptLoginsTest, ThatCouldNotBeWrittenAreWrittenWithTheNextOnes) {
    start();
    const std::string first = login(), second = login(), third = login();
    EXPECT_TRUE(log_out(first));
    fs::rename(folder.path() / "ended-logins", folder.path() / "aside");
    fs::create_directories(folder.path() / "ended-logins");
    bool kept = true;
    life->gate.logout(with(second),
                      [&](const core::Result<void>& done) { kept = done.has_value(); });
    EXPECT_FALSE(kept);
    fs::remove(folder.path() / "ended-logins");
    EXPECT_TRUE(log_out(third));
    start();
    for (const std::string& each : {first, second, third})
        EXPECT_FALSE(good(each));
}

TEST_F(KeptLoginsTest, SayWhereALogoutCouldNotBeKept) {
    start();
    const std::string mine = login();
    fs::create_directories(folder.path() / "ended-logins" / "in the way");
    bool kept = true;
    EXPECT_NE(life->gate.logout(with(mine),
                                [&](const core::Result<void>& done) { kept = done.has_value(); }),
              "");
    EXPECT_FALSE(kept);
    EXPECT_FALSE(good(mine));
}

TEST(WriteBehindFile, WritesTheNewestTextForAllThatWaitOnAThreadOfItsOwn) {
    const TemporaryFolder folder;
    HandClock clock;
    HandLoop loop(clock);
    int done = 0;
    {
        WriteBehindFile file(loop, folder / "file");
        for (int i = 0; i < 1000; ++i)
            file.put(std::to_string(i),
                     [&](const core::Result<void>& kept) { done += kept ? 1 : 0; });
        EXPECT_EQ(done, 0);
    } // its thread has ended: the loop is this one's again
    loop.advance(std::chrono::milliseconds(0));
    EXPECT_EQ(done, 1000);
    EXPECT_EQ(*read_private_file(folder / "file", 100), "999");
}

TEST(WriteBehindFile, AddsToTheTextInTheOrderOfTheCalls) {
    const TemporaryFolder folder;
    HandClock clock;
    HandLoop loop(clock);
    int done = 0;
    const auto count = [&](const core::Result<void>& kept) { done += kept ? 1 : 0; };
    {
        WriteBehindFile file(loop, folder / "file");
        file.append("lost", count);
        file.put("a", count);
        for (const char* more : {"b", "c", "d"})
            file.append(more, count);
    }
    loop.advance(std::chrono::milliseconds(0));
    EXPECT_EQ(done, 5);
    EXPECT_EQ(*read_private_file(folder / "file", 100), "abcd");
}

TEST_F(KeptLoginsTest, SayWhatIsWrongWithAKeyThatIsNone) {
    std::ofstream(folder.path() / "login-key") << "short\n";
    SystemEntropy entropy;
    const auto kept = Logins::open(folder.path(), entropy, {});
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().code, core::Error::Code::Corrupt);
    EXPECT_EQ(kept.error().message.find(folder.path().string()), std::string::npos);
}

} // namespace wakesurf::server::logins_test
