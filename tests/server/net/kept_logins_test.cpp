// Logins beyond a restart: the cookies of one life of the server, shown to the next.
#include "server/net/gate.hpp"
#include "server/net/kept_logins.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server::kept_logins_test {

namespace {

using wakesurf::tests::TemporaryFolder;
namespace fs = std::filesystem;

const std::string token(64, 'a');
constexpr std::int64_t day = 24 * 3600;

/// A server's life: what knows logins, on one folder.
struct Life {
    Life(const fs::path& folder, HandClock& clock, const std::int64_t& wall, std::string secret)
        : loop(clock), grants({loop, clock, entropy, [&wall] { return wall; }}),
          kept(*KeptLogins::open(folder, entropy, [&wall] { return wall; })),
          gate({std::move(secret), "127.0.0.1", 8080, {}, false, &kept, [&wall] { return wall; }},
               entropy,
               clock,
               grants) {}

    SystemEntropy entropy;
    HandLoop loop;
    Grants grants;
    KeptLogins kept;
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

    static HttpRequest with(const std::string& cookie) {
        HttpRequest out;
        out.method = "POST";
        out.headers = {
            {"host", "localhost:8080"}, {"origin", "http://localhost:8080"}, {"cookie", cookie}};
        return out;
    }

    std::string login(const std::string& secret = token) {
        const auto value = life->gate.login(with(""), secret);
        return value ? value->substr(0, value->find(';')) : "refused";
    }

    bool good(const std::string& cookie) { return life->gate.check(with(cookie)).has_value(); }

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
    for (std::size_t i = mine.find('=') + 1; i < mine.size(); ++i) {
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
    EXPECT_EQ(life->gate.logout(with(mine))->people.size(), 1u);
    pass(1);
    start();
    EXPECT_FALSE(good(mine));
    EXPECT_TRUE(good(other));
    EXPECT_TRUE(life->gate.logout(with(mine))->people.empty());
    EXPECT_TRUE(life->gate.logout(with(other)));
    EXPECT_FALSE(good(other)) << "one of an earlier life";
    start();
    EXPECT_FALSE(good(other));
    EXPECT_EQ(fs::status(folder.path() / "ended-logins").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(KeptLoginsTest, AreOverAMonthAfterTheyWereMadeHoweverManyRestartsThereWere) {
    start();
    const std::string mine = login();
    for (int i = 1; i < 30; ++i) {
        pass(day);
        start();
        EXPECT_TRUE(good(mine)) << i;
    }
    pass(day);
    EXPECT_FALSE(good(mine)) << "in the life that adopted it";
    start();
    EXPECT_FALSE(good(mine));
}

TEST_F(KeptLoginsTest, AreOverWhereAServerSawThemIdleForAWeek) {
    start();
    const std::string mine = login();
    pass(60);
    start();
    EXPECT_TRUE(good(mine));
    pass(7 * day);
    EXPECT_FALSE(good(mine));
    EXPECT_TRUE(good(login()));
    EXPECT_FALSE(good(mine)) << "not adopted once more";
    start();
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

TEST_F(KeptLoginsTest, AreForgottenTogetherWhereTooManyHaveLoggedOutNeverThoseOfAnotherLink) {
    start();
    const std::string stays = login();
    const std::string out = login();
    ASSERT_TRUE(life->gate.logout(with(out)));
    for (std::size_t i = 0; i < KeptLogins::most_ended; ++i)
        life->kept.end("share-1", std::to_string(i), wall + static_cast<std::int64_t>(i));
    const auto last = wall + static_cast<std::int64_t>(KeptLogins::most_ended);
    EXPECT_TRUE(life->kept.ended("share-1", "never seen", wall));
    EXPECT_FALSE(life->kept.ended("share-1", "never seen", last + 1));
    pass(1);
    start();
    EXPECT_TRUE(life->kept.ended("share-1", "7", wall));
    EXPECT_TRUE(good(stays));
    EXPECT_FALSE(good(out));
    EXPECT_LT(fs::file_size(folder.path() / "ended-logins"), 200u);
    pass(31 * day);
    life->kept.end("", "one more", wall);
    EXPECT_FALSE(life->kept.ended("share-1", "7", wall - 31 * day)) << "too old to matter";
}

TEST_F(KeptLoginsTest, SayWhatIsWrongWithAKeyThatIsNone) {
    std::ofstream(folder.path() / "login-key") << "short\n";
    SystemEntropy entropy;
    const auto kept = KeptLogins::open(folder.path(), entropy);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().code, core::Error::Code::Corrupt);
    EXPECT_EQ(kept.error().message.find(folder.path().string()), std::string::npos);
}

} // namespace wakesurf::server::kept_logins_test
