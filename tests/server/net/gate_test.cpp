#include "server/base/limits.hpp"
#include "server/base/metrics.hpp"
#include "server/net/gate.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server::gate_test {

namespace {

class CountingEntropy final : public Entropy {
  public:
    void fill(std::span<std::byte> out) override {
        for (std::byte& each : out)
            each = static_cast<std::byte>(next_++ % 251); // no period of a secret's length
    }

  private:
    unsigned next_ = 0;
};

const std::string token(64, 'a');

struct GateTest : testing::Test {
    CountingEntropy entropy;
    HandClock clock;
    HandLoop loop{clock};
    Grants grants{{loop, clock, entropy, [] { return std::int64_t{0}; }}};
    Metrics metrics{clock};
    std::int64_t wall = 1'700'000'000;
    Gate gate{{token,
               "127.0.0.1",
               8080,
               {"https://viewer.example", "http://lab:9000"},
               false,
               nullptr,
               [this] { return wall; }},
              entropy,
              clock,
              grants,
              &metrics};

    static HttpRequest request(std::string method,
                               std::vector<std::pair<std::string, std::string>> headers) {
        HttpRequest out;
        out.method = std::move(method);
        out.headers = std::move(headers);
        return out;
    }

    unsigned status(const HttpRequest& request, bool open = false) {
        if (open) {
            const auto refusal = gate.check_open(request);
            return refusal ? refusal->status : 200;
        }
        const auto identity = gate.check(request);
        return identity ? 200 : identity.error().status;
    }

    /// What the page keeps.
    std::string login(const std::string& secret = token,
                      std::optional<std::string> had = {},
                      const std::string& address = {}) {
        HttpRequest from;
        from.from = address;
        const auto made = gate.login(from, {secret, std::move(had)});
        return made ? made->login : "refused";
    }

    std::optional<Identity> who(const std::string& secret) {
        const auto visitor = gate.check(
            request("GET", {{"host", "localhost"}, {"authorization", "Bearer " + secret}}));
        return visitor ? std::optional<Identity>(*visitor) : std::nullopt;
    }

    /// The person of a login, as a browser of this address shows it.
    std::string person(const std::string& secret, std::string address = {}) {
        HttpRequest from =
            request("GET", {{"host", "localhost"}, {"authorization", "Bearer " + secret}});
        from.from = std::move(address);
        return gate.check(from)->person;
    }

    /// What a request without a token to an open path is answered, with an answer of so many bytes.
    unsigned open(const std::string& address, std::size_t bytes = 0) {
        HttpRequest from = request("GET", {{"host", "localhost"}});
        from.from = address;
        const auto refusal = gate.count_open(from, bytes);
        return refusal ? refusal->status : 200;
    }
};

} // namespace

TEST_F(GateTest, LetsInOnlyHostsItGoesBy) {
    const std::vector<std::pair<std::string, unsigned>> hosts{
        {"127.0.0.1:8080", 200},
        {"localhost:8080", 200},
        {"LOCALHOST", 200},
        {"[::1]:8080", 200},
        {"localhost:9000", 200},
        {"lab", 200},
        {"viewer.example:443", 200},
        {"evil.example", 403},
        {"localhost.evil.example", 403},
        {"127.0.0.1.evil.example", 403},
        {"", 403},
        {"localhost:", 403},
        {"localhost:80a", 403},
        {"localhost:65535", 200},
        {"localhost:65536", 403},
        {"localhost:99999", 403},
        {"user@localhost", 403},
        {"localhost/x", 403},
        {"[::1", 403},
        {"::1", 403},
        {"localhost.", 403},
        {"127.0.0.2:9000", 200},
        {"127.0.0.evil.example", 403},
        {"2130706433", 403},
    };
    for (const auto& [host, expected] : hosts)
        EXPECT_EQ(status(request("GET", {{"host", host}}), true), expected) << host;
    EXPECT_EQ(status(request("GET", {}), true), 403u);
    EXPECT_EQ(status(request("GET", {{"host", "localhost"}, {"host", "localhost"}}), true), 403u);
}

TEST_F(GateTest, LetsInOnlyOriginsOnTheList) {
    const std::vector<std::pair<std::string, unsigned>> origins{
        {"http://127.0.0.1:8080", 200},
        {"http://localhost:8080", 200},
        {"http://[::1]:8080", 200},
        {"https://viewer.example", 200},
        {"http://lab:9000", 200},
        {"http://localhost:8081", 403},
        {"https://localhost:8080", 403},
        {"HTTP://LOCALHOST:8080", 403},
        {"http://localhost:8080.evil.example", 403},
        {"http://localhost:8080/", 403},
        {"http://evil.example", 403},
        {"http://viewer.example", 403},
        {"https://viewer.example.evil", 403},
        {"https://xviewer.example", 403},
        {"https://viewer.example:444", 403},
        {"https://user@viewer.example", 403},
        {"null", 403},
        {"", 403},
        {"file://", 403},
    };
    for (const auto& [origin, expected] : origins)
        EXPECT_EQ(status(request("GET", {{"host", "localhost"}, {"origin", origin}}), true),
                  expected)
            << origin;
    EXPECT_EQ(status(request("GET", {{"host", "localhost"},
                                     {"origin", "http://localhost:8080"},
                                     {"origin", "http://localhost:8080"}}),
                     true),
              403u);
}

TEST_F(GateTest, LetsInThePageThatCameThroughATunnelToAnotherPortOfTheBrowsersMachine) {
    const auto through = [&](const std::string& host, const std::string& origin) {
        return status(request("GET", {{"host", host}, {"origin", origin}}), true);
    };
    EXPECT_EQ(through("localhost:9000", "http://localhost:9000"), 200u);
    EXPECT_EQ(through("127.0.0.1:9000", "http://127.0.0.1:9000"), 200u);
    EXPECT_EQ(through("[::1]:9000", "http://[::1]:9000"), 200u);
    EXPECT_EQ(through("localhost", "http://localhost"), 200u);
    EXPECT_EQ(through("localhost:9000", "http://localhost:9001"), 403u) << "another page there";
    EXPECT_EQ(through("localhost:9000", "http://127.0.0.1:9000"), 403u);
    EXPECT_EQ(through("localhost:9000", "https://localhost:9000"), 403u);
    EXPECT_EQ(through("lab:9001", "http://lab:9001"), 403u) << "DNS may say anything of a name";
    EXPECT_EQ(through("evil.example:9000", "http://evil.example:9000"), 403u);
    EXPECT_EQ(through("localhost:9000", "http://localhost:9000/"), 403u);
    EXPECT_EQ(status(request("GET", {{"host", "localhost:9000"},
                                     {"origin", "http://localhost:9000"},
                                     {"origin", "http://localhost:9000"}}),
                     true),
              403u);
}

TEST_F(GateTest, LetsInThePageOfAPortalWhoseProxyAsksByTheNodesOwnName) {
    const auto through = [&](const std::string& host, const std::string& origin) {
        return status(request("GET", {{"host", host}, {"origin", origin}}), true);
    };
    EXPECT_EQ(through("lab:9000", "https://viewer.example"), 200u);
    EXPECT_EQ(through("lab:9000", "https://evil.example"), 403u);
    EXPECT_EQ(through("node:9000", "https://viewer.example"), 403u) << "no such name was given";
}

TEST_F(GateTest, NeverRefusesThePagesOwnFilesForTheirOrigin) {
    const auto file = [&](const std::string& host, const std::string& origin) {
        return gate.check_host(request("GET", {{"host", host}, {"origin", origin}}));
    };
    EXPECT_FALSE(file("localhost:9000", "http://anything.example"));
    EXPECT_FALSE(file("lab", "null"));
    EXPECT_TRUE(file("evil.example", "http://evil.example")) << "DNS rebinding";
}

TEST_F(GateTest, TellsItsHealthUnderAnyHostButNotToOtherPages) {
    EXPECT_FALSE(gate.check_origin(request("GET", {{"host", "10.0.0.7:8080"}})));
    EXPECT_FALSE(gate.check_origin(request("GET", {})));
    EXPECT_TRUE(gate.check_origin(
        request("GET", {{"host", "localhost"}, {"origin", "http://evil.example"}})));
}

TEST_F(GateTest, TakesTheTokenOrALoginAsBearer) {
    const auto with = [](const char* name, const std::string& value) {
        return request("GET", {{"host", "localhost"}, {name, value}});
    };
    EXPECT_EQ(status(request("GET", {{"host", "localhost"}})), 401u);
    EXPECT_EQ(status(with("authorization", "Bearer " + token)), 200u);
    EXPECT_EQ(status(with("authorization", "bearer " + token)), 200u);
    EXPECT_EQ(status(with("authorization", "Basic " + token)), 401u);
    EXPECT_EQ(status(with("authorization", token)), 401u);
    EXPECT_EQ(status(with("authorization", "Bearer " + token + "a")), 401u);
    EXPECT_EQ(status(with("authorization", "Bearer " + token.substr(1))), 401u);
    EXPECT_EQ(status(with("authorization", "Bearer ")), 401u);
    EXPECT_EQ(status(with("authorization", "Bearer " + login())), 200u);
    EXPECT_EQ(status(with("authorization", "Bearer x" + login())), 401u);
    EXPECT_EQ(status(request("GET", {{"host", "localhost"},
                                     {"authorization", "Bearer " + token},
                                     {"authorization", "Bearer " + token}})),
              401u);
}

TEST_F(GateTest, LetsNoOneInByACookie) {
    const auto with = [](const std::string& cookie) {
        return request(
            "GET",
            {{"host", "localhost:8080"}, {"origin", "http://localhost:8080"}, {"cookie", cookie}});
    };
    for (const std::string& secret : {token, login()})
        for (const std::string name : {"wakesurf_session_8080", "wakesurf_login", "login"}) {
            EXPECT_EQ(status(with(name + "=" + secret)), 401u);
            HttpRequest upgrade = with(name + "=" + secret);
            upgrade.upgrade = true;
            EXPECT_EQ(status(upgrade), 401u);
            EXPECT_FALSE(gate.is_host(with(name + "=" + secret)));
        }
    // Nor does one that another port has set make anybody less.
    HttpRequest host =
        with("wakesurf_session_8080=" + login(grants.make("main", Role::Viewer, {})->key));
    host.headers.emplace_back("authorization", "Bearer " + login());
    EXPECT_EQ(*gate.check(host), Identity{});
}

TEST_F(GateTest, TakesALoginAmongTheSubprotocolsOfAWebSocketAndOfNothingElse) {
    const std::string mine = login();
    const auto offering = [&](std::vector<std::string> offers) {
        HttpRequest upgrade =
            request("GET", {{"host", "localhost"}, {"origin", "http://localhost:8080"}});
        for (std::string& each : offers)
            upgrade.headers.emplace_back("sec-websocket-protocol", std::move(each));
        upgrade.upgrade = true;
        return upgrade;
    };
    EXPECT_EQ(status(offering({"wakesurf.v1, wakesurf.login." + mine})), 200u);
    EXPECT_EQ(status(offering({"wakesurf.v1", "wakesurf.login." + mine})), 200u);
    EXPECT_EQ(status(offering({"wakesurf.v1,wakesurf.login." + mine + " "})), 200u);
    EXPECT_EQ(status(offering({"wakesurf.v1, wakesurf.login." + mine + "0"})), 401u);
    EXPECT_EQ(status(offering({"wakesurf.v1, " + mine})), 401u);
    EXPECT_EQ(status(offering({"wakesurf.v1, wakesurf.login.x, wakesurf.login." + mine})), 401u);
    EXPECT_EQ(status(offering({"wakesurf.v1"})), 401u);
    HttpRequest both = offering({"wakesurf.v1, wakesurf.login." + mine});
    both.headers.emplace_back("authorization", "Bearer wrong");
    EXPECT_EQ(status(both), 401u);
    HttpRequest plain = offering({"wakesurf.v1, wakesurf.login." + mine});
    plain.upgrade = false;
    EXPECT_EQ(status(plain), 401u);
    HttpRequest foreign = offering({"wakesurf.v1, wakesurf.login." + mine});
    foreign.headers[1].second = "http://localhost:8081";
    EXPECT_EQ(status(foreign), 403u);
}

TEST_F(GateTest, LimitsWrongTokensButNeverTheRightOne) {
    const auto attempt = [&](const std::string& secret) {
        return status(
            request("GET", {{"host", "localhost"}, {"authorization", "Bearer " + secret}}));
    };
    int refused = 0;
    for (int i = 0; i < 1000; ++i)
        refused += attempt("wrong") == 429 ? 1 : 0;
    EXPECT_EQ(refused, 980);
    EXPECT_EQ(attempt(token), 200u);
    clock.time += std::chrono::seconds(1);
    EXPECT_EQ(attempt("wrong"), 401u);
}

TEST_F(GateTest, KnowsAHostByTheHeaderAndCountsNothing) {
    const auto host = [&](std::vector<std::pair<std::string, std::string>> headers) {
        return gate.is_host(request("POST", std::move(headers)));
    };
    const std::pair<std::string, std::string> here{"host", "localhost"};
    EXPECT_TRUE(host({here, {"authorization", "Bearer " + token}}));
    EXPECT_TRUE(host({here, {"authorization", "Bearer " + login()}}));
    EXPECT_FALSE(host({{"host", "evil.example"}, {"authorization", "Bearer " + token}}));
    const auto link = grants.make("main", Role::Editor, {});
    ASSERT_TRUE(link);
    EXPECT_FALSE(host({here, {"authorization", "Bearer " + link->key}}));
    for (int i = 0; i < 1000; ++i) {
        EXPECT_FALSE(host({here, {"authorization", "Bearer wrong"}}));
        EXPECT_FALSE(host({here}));
    }
    EXPECT_EQ(status(request("POST", {here, {"authorization", "Bearer wrong"}})), 401u);
}

TEST_F(GateTest, LimitsWhatAnAddressAsksForWithoutAToken) {
    std::size_t answered = 0;
    for (int i = 0; i < 10000; ++i)
        answered += open("192.0.2.1") == 200 ? 1 : 0;
    EXPECT_EQ(static_cast<double>(answered), limits::strangers_at_once);
    HttpRequest closed = request("GET", {{"host", "localhost"}});
    closed.from = "192.0.2.1";
    const auto refused = gate.check(closed);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, 429u) << "paths that need a token count as well";
    EXPECT_EQ(refused.error().headers.back(),
              (std::pair<std::string, std::string>("Retry-After", "1")));
    EXPECT_EQ(open("192.0.2.2"), 200u) << "another address";
    clock.time += std::chrono::seconds(1);
    EXPECT_EQ(open("192.0.2.1"), 200u);
    EXPECT_NE(metrics.text({}).find(R"(wakesurf_over_budget_total{kind="without_token"} 6001)"),
              std::string::npos)
        << metrics.text({});
}

TEST_F(GateTest, CountsALargeAnswerToAStrangerForMore) {
    const std::size_t large = 99 * limits::strangers_bytes;
    int answered = 0;
    while (answered < 1000 && open("192.0.2.1", large) == 200)
        ++answered;
    EXPECT_EQ(answered, static_cast<int>(limits::strangers_at_once / 100.0));
}

TEST_F(GateTest, LetsThoseWhoShowATokenInHoweverManyStrangersShareTheirAddress) {
    while (open("192.0.2.1") == 200) {
    }
    HttpRequest known =
        request("GET", {{"host", "localhost"}, {"authorization", "Bearer " + login()}});
    known.from = "192.0.2.1";
    EXPECT_FALSE(gate.count_open(known));
    EXPECT_TRUE(gate.check(known));
    known.headers.back() = {"authorization", "Bearer " + token};
    EXPECT_FALSE(gate.count_open(known));
    known.headers.back() = {"authorization", "Bearer wrong"};
    EXPECT_EQ(gate.count_open(known)->status, 429u);
    EXPECT_NE(login(token, {}, "192.0.2.1"), "refused") << "they log in";
}

TEST_F(GateTest, MakesALoginForTheTokenOnly) {
    EXPECT_EQ(gate.login({}, {"wrong", {}}).error().status, 401u);
    EXPECT_EQ(gate.login({}, {{}, "wrong"}).error().status, 401u);
    EXPECT_EQ(gate.login({}, {"wrong", login()}).error().status, 401u) << "the token counts";
    const auto made = gate.login({}, {token, {}});
    ASSERT_TRUE(made);
    EXPECT_EQ(made->login.find(token), std::string::npos);
    EXPECT_EQ(made->holder.session, "");
}

TEST_F(GateTest, KnowsWhoComesByTheTokenTheKeyOfAShareLinkOrTheirLogins) {
    const Identity host;
    const auto made = grants.make("session-1", Role::Editor, {});
    const Identity editor{Role::Editor, "session-1", made->grant.id};
    EXPECT_EQ(who(token), host);
    EXPECT_EQ(who(made->key), editor);
    EXPECT_EQ(who(login()), host);
    EXPECT_EQ(who(login(made->key)), editor);
    EXPECT_EQ(gate.login({}, {made->key, {}})->holder.session, "session-1");
    EXPECT_EQ(who(made->grant.id), std::nullopt);
}

TEST_F(GateTest, EndsAKeyAndItsLoginsWithTheShareLink) {
    const auto taken_back = grants.make("main", Role::Viewer, {});
    const auto expiring = grants.make("main", Role::Viewer, std::chrono::seconds(60));
    const std::string first = login(taken_back->key);
    const std::string second = login(expiring->key);
    const Visitor early =
        *gate.check(request("GET", {{"host", "localhost"}, {"authorization", "Bearer " + second}}));
    EXPECT_TRUE(gate.still(early));
    ASSERT_TRUE(grants.revoke("main", taken_back->grant.id));
    EXPECT_EQ(who(first), std::nullopt);
    EXPECT_EQ(who(taken_back->key), std::nullopt);
    EXPECT_EQ(gate.login({}, {{}, first}).error().status, 401u) << "it is not renewed";
    EXPECT_TRUE(who(second));
    clock.time += std::chrono::seconds(60);
    EXPECT_EQ(who(second), std::nullopt);
    EXPECT_EQ(who(expiring->key), std::nullopt);
    EXPECT_FALSE(gate.still(early));
    EXPECT_TRUE(gate.still({}));
}

TEST_F(GateTest, EndsEveryLinkWithTheTokenItWasMadeUnder) {
    const auto one = grants.make("main", Role::Host, {});
    const auto two = grants.make("session-1", Role::Viewer, {});
    const std::string by_one = login(one->key);
    EXPECT_EQ(grants.end_all("the server has a new token"), 2u);
    for (const std::string& each : {one->key, two->key, by_one})
        EXPECT_EQ(who(each), std::nullopt);
    EXPECT_TRUE(who(token));
}

TEST_F(GateTest, RenewsTheLoginOfABrowserThatLogsInAgain) {
    const std::string mine = login();
    wall += 60;
    EXPECT_EQ(person(login(token, mine)), person(mine));
    EXPECT_NE(person(login()), person(mine)) << "another browser's is another one";
    const auto made = grants.make("main", Role::Viewer, {});
    const std::string viewer = login(made->key, mine);
    EXPECT_NE(person(viewer), person(mine)) << "a link never gives what the token gave";
    EXPECT_EQ(who(viewer)->role, Role::Viewer);
    EXPECT_TRUE(who(mine)) << "nor does it take it";
}

TEST_F(GateTest, LetsNobodyKeepOthersOutByLoggingInTooOften) {
    const auto made = grants.make("main", Role::Viewer, {});
    const std::string host = login();
    const std::string used = login(made->key);
    for (int i = 0; i < 20000; ++i)
        ASSERT_TRUE(who(login(made->key))) << i;
    EXPECT_TRUE(who(host));
    EXPECT_TRUE(who(used));
    EXPECT_TRUE(who(login(made->key))) << "one more, of the same link and address";
}

TEST_F(GateTest, EndsALoginThatIsNotRenewedForAWeekOrIsAMonthOld) {
    constexpr std::int64_t day = 24 * 3600;
    const std::string idle = login();
    std::string daily = login();
    for (int i = 1; i < 30; ++i) {
        wall += day;
        EXPECT_EQ(who(idle).has_value(), i < 7) << i;
        const auto renewed = gate.login({}, {{}, daily});
        ASSERT_TRUE(renewed) << i;
        daily = renewed->login;
        EXPECT_TRUE(who(daily)) << i;
    }
    wall += day;
    EXPECT_EQ(who(daily), std::nullopt);
    EXPECT_FALSE(gate.login({}, {{}, daily}));
}

TEST_F(GateTest, EndsALoginWithAllItsTextsWhereItsBrowserLogsOut) {
    const std::string mine = login();
    wall += 60;
    const std::string renewed = login(token, mine);
    const std::string other = login();
    const HttpRequest leaving =
        request("POST", {{"host", "localhost"}, {"authorization", "Bearer " + mine}});
    const Visitor early = *gate.check(leaving);
    int kept = 0;
    const auto count = [&](const core::Result<void>& done) { kept += done ? 1 : 0; };
    EXPECT_EQ(gate.logout(leaving, count), early.person);
    EXPECT_EQ(who(mine), std::nullopt);
    EXPECT_EQ(who(renewed), std::nullopt);
    EXPECT_FALSE(gate.still(early)) << "answers under way are dropped";
    EXPECT_TRUE(who(other));
    EXPECT_EQ(gate.logout(leaving, count), "");
    EXPECT_EQ(gate.logout(request("POST", {{"host", "localhost"}}), count), "");
    EXPECT_EQ(
        gate.logout(request("POST", {{"host", "localhost"}, {"cookie", "a=" + other}}), count), "");
    EXPECT_EQ(kept, 4);
    EXPECT_TRUE(who(other));
}

TEST_F(GateTest, TellsPeopleOfOneLinkApartByTheirLoginOrTheirAddress) {
    const auto made = grants.make("main", Role::Viewer, {});
    const std::string first = login(made->key);
    EXPECT_NE(person(first, "a"), person(login(made->key), "a"));
    EXPECT_EQ(person(first, "a"), person(first, "b"));
    EXPECT_NE(person(made->key, "a"), person(made->key, "b"));
}

TEST_F(GateTest, TakesEverybodyForAHostWhereThereIsNoAuthentication) {
    Gate open{{{}, "127.0.0.1", 8080, {}}, entropy, clock, grants};
    EXPECT_EQ(*open.check(request("GET", {{"host", "localhost"}})), Identity{});
    EXPECT_FALSE(open.check(request("GET", {{"host", "evil.example"}})));
}

TEST(Loopback, IsWhatOnlyThisMachineReaches) {
    for (const char* host : {"localhost", "127.0.0.1", "127.8.8.8", "::1", "[::1]", "LocalHost"})
        EXPECT_TRUE(is_loopback(host)) << host;
    for (const char* host :
         {"0.0.0.0", "::", "192.168.0.1", "127.evil.example", "localhost.example", "127.0.0"})
        EXPECT_FALSE(is_loopback(host)) << host;
}

} // namespace wakesurf::server::gate_test
