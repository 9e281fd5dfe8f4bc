#include "server/limits.hpp"
#include "server/metrics/metrics.hpp"
#include "server/net/gate.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <map>
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
    Gate gate{{token, "127.0.0.1", 8080, {"https://viewer.example", "http://lab:9000"}},
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

    std::string cookie(const std::string& secret = token, const HttpRequest& from = {}) {
        const auto value = gate.login(from, secret);
        return value ? value->substr(0, value->find(';')) : "refused";
    }

    std::optional<Identity> who(const char* header, const std::string& value) {
        const auto visitor = gate.check(request("GET", {{"host", "localhost"}, {header, value}}));
        return visitor ? std::optional<Identity>(*visitor) : std::nullopt;
    }

    /// What a request without a token to an open path is answered, with an answer of so many bytes.
    unsigned open(const std::string& address, std::size_t bytes = 0) {
        HttpRequest from = request("GET", {{"host", "localhost"}});
        from.from = address;
        const auto refusal = gate.count_open(from, bytes);
        return refusal ? refusal->status : 200;
    }

    /// From an address of one's own.
    std::string cookie_from(const std::string& address, const std::string& secret) {
        HttpRequest from;
        from.from = address;
        return cookie(secret, from);
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

TEST_F(GateTest, NeverRefusesThePagesOwnFilesForTheirOrigin) {
    const auto file = [&](const std::string& host, const std::string& origin) {
        return gate.check_file(request("GET", {{"host", host}, {"origin", origin}}));
    };
    EXPECT_FALSE(file("localhost:9000", "http://anything.example"));
    EXPECT_FALSE(file("lab", "null"));
    EXPECT_TRUE(file("evil.example", "http://evil.example")) << "DNS rebinding";
}

TEST_F(GateTest, TellsItsHealthUnderAnyHostButNotToOtherPages) {
    EXPECT_FALSE(gate.check_health(request("GET", {{"host", "10.0.0.7:8080"}})));
    EXPECT_FALSE(gate.check_health(request("GET", {})));
    EXPECT_TRUE(gate.check_health(
        request("GET", {{"host", "localhost"}, {"origin", "http://evil.example"}})));
}

TEST_F(GateTest, TakesTheTokenAsBearerOrItsCookie) {
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
    EXPECT_EQ(status(with("cookie", cookie())), 200u);
    EXPECT_EQ(status(with("cookie", "a=b; wakesurf_session_8080=0; " + cookie())), 200u);
    EXPECT_EQ(status(with("cookie", "wakesurf_session_8080=" + token)), 401u)
        << "the cookie is not the token";
    EXPECT_EQ(status(with("cookie", "x" + cookie())), 401u);
    EXPECT_EQ(status(request("GET", {{"host", "localhost"},
                                     {"authorization", "Bearer " + token},
                                     {"authorization", "Bearer " + token}})),
              401u);
}

TEST_F(GateTest, WantsAnOriginFromWhoeverPostsOrUpgradesWithACookie) {
    HttpRequest upgrade = request("GET", {{"host", "localhost"}, {"cookie", cookie()}});
    upgrade.upgrade = true;
    EXPECT_EQ(status(upgrade), 403u);
    upgrade.headers.emplace_back("origin", "http://localhost:8080");
    EXPECT_EQ(status(upgrade), 200u);
    HttpRequest post = request("POST", {{"host", "localhost"}, {"cookie", cookie()}});
    EXPECT_EQ(status(post), 403u);
    post.headers.emplace_back("authorization", "Bearer " + token);
    EXPECT_EQ(status(post), 200u);
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
    EXPECT_TRUE(host({here, {"cookie", cookie()}, {"origin", "http://localhost:8080"}}));
    EXPECT_FALSE(host({here, {"cookie", cookie()}})) << "another page's, perhaps";
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
    EXPECT_EQ(refused.error().retry_after.count(), 1);
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
    HttpRequest known = request("GET", {{"host", "localhost"}, {"cookie", cookie()}});
    known.from = "192.0.2.1";
    EXPECT_FALSE(gate.count_open(known));
    EXPECT_TRUE(gate.check(known));
    known.headers.back() = {"authorization", "Bearer " + token};
    EXPECT_FALSE(gate.count_open(known));
    known.headers.back() = {"authorization", "Bearer wrong"};
    EXPECT_EQ(gate.count_open(known)->status, 429u);
    EXPECT_NE(cookie_from("192.0.2.1", token), "refused") << "they log in";
}

TEST_F(GateTest, GivesTheCookieForTheTokenOnly) {
    EXPECT_EQ(gate.login({}, "wrong").error().status, 401u);
    const auto value = gate.login({}, token);
    ASSERT_TRUE(value);
    EXPECT_NE(value->find("HttpOnly; SameSite=Strict; Path=/"), std::string::npos);
    EXPECT_EQ(value->find(token), std::string::npos);
}

TEST_F(GateTest, KnowsWhoComesByTheTokenTheKeyOfAShareLinkOrTheirCookies) {
    const Identity host;
    const auto made = grants.make("session-1", Role::Editor, {});
    const Identity editor{Role::Editor, "session-1", made->grant.id};
    EXPECT_EQ(who("authorization", "Bearer " + token), host);
    EXPECT_EQ(who("authorization", "Bearer " + made->key), editor);
    EXPECT_EQ(who("cookie", cookie()), host);
    EXPECT_EQ(who("cookie", cookie(made->key)), editor);
    EXPECT_EQ(who("cookie", "wakesurf_session_8080=" + made->key), std::nullopt);
    EXPECT_EQ(who("authorization", "Bearer " + made->grant.id), std::nullopt);
}

TEST_F(GateTest, EndsAKeyAndItsCookiesWithTheShareLink) {
    const auto taken_back = grants.make("main", Role::Viewer, {});
    const auto expiring = grants.make("main", Role::Viewer, std::chrono::seconds(60));
    const std::string first = cookie(taken_back->key);
    const std::string second = cookie(expiring->key);
    const Visitor early = *gate.check(request("GET", {{"host", "localhost"}, {"cookie", second}}));
    EXPECT_TRUE(gate.still(early));
    ASSERT_TRUE(grants.revoke("main", taken_back->grant.id));
    EXPECT_EQ(who("cookie", first), std::nullopt);
    EXPECT_EQ(who("authorization", "Bearer " + taken_back->key), std::nullopt);
    EXPECT_TRUE(who("cookie", second));
    clock.time += std::chrono::seconds(60);
    EXPECT_EQ(who("cookie", second), std::nullopt);
    EXPECT_EQ(who("authorization", "Bearer " + expiring->key), std::nullopt);
    EXPECT_FALSE(gate.still(early));
    EXPECT_TRUE(gate.still({}));
}

TEST_F(GateTest, GivesABrowserThatLogsInAgainTheCookieItHas) {
    const std::string mine = cookie();
    EXPECT_EQ(cookie(token, request("POST", {{"cookie", mine}})), mine);
    EXPECT_NE(cookie(), mine) << "another browser's is another one";
    const auto made = grants.make("main", Role::Viewer, {});
    const std::string viewer = cookie(made->key, request("POST", {{"cookie", mine}}));
    EXPECT_NE(viewer, mine) << "a link never gives what the token gave";
    EXPECT_EQ(who("cookie", viewer)->role, Role::Viewer);
}

TEST_F(GateTest, LeavesTheLoginsOfOtherServersOnTheHostAlone) {
    Gate other{{"another-token", "127.0.0.1", 9000, {}}, entropy, clock, grants};
    std::map<std::string, std::string> jar; ///< of a browser: one for the host, whatever the port
    const auto cookies = [&] {
        std::string out;
        for (const auto& [name, value] : jar)
            out += (out.empty() ? "" : "; ") + name + "=" + value;
        return out;
    };
    const auto login = [&](Gate& to, const char* host, const std::string& secret) {
        const auto value =
            *to.login(request("POST", {{"host", host}, {"cookie", cookies()}}), secret);
        const auto equals = value.find('=');
        jar[value.substr(0, equals)] = value.substr(equals + 1, value.find(';') - equals - 1);
    };
    const auto comes_in = [&](Gate& to, const char* host) {
        return to.check(request("GET", {{"host", host}, {"cookie", cookies()}})).has_value();
    };
    login(gate, "localhost:8080", token);
    login(other, "localhost:9000", "another-token");
    EXPECT_TRUE(comes_in(gate, "localhost:8080"));
    EXPECT_TRUE(comes_in(other, "localhost:9000"));
    EXPECT_EQ(jar.size(), 2u);
    // In containers both listen on one port, and browsers know them by others.
    Gate twin{{"a-third-token", "127.0.0.1", 8080, {}}, entropy, clock, grants};
    login(gate, "[::1]:8081", token);
    login(twin, "[::1]:8082", "a-third-token");
    EXPECT_TRUE(comes_in(gate, "[::1]:8081"));
    EXPECT_TRUE(comes_in(twin, "[::1]:8082"));
    login(gate, "[::1]", token);
    EXPECT_TRUE(comes_in(gate, "[::1]")) << "a default port is not said";
}

TEST_F(GateTest, LetsNobodyPushOutAnothersLoginByLoggingInTooOften) {
    const auto made = grants.make("main", Role::Viewer, {});
    const auto other_link = grants.make("main", Role::Viewer, {});
    const std::string host = cookie();
    const std::string used = cookie(made->key);
    const std::string elsewhere = cookie_from("192.0.2.1", made->key);
    EXPECT_TRUE(who("cookie", used));
    const std::string never_used = cookie(made->key);
    for (std::size_t i = 2; i < limits::logins_from_one; ++i)
        EXPECT_NE(cookie(made->key), "refused") << i;
    const auto refused = gate.login({}, made->key);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, 429u);
    EXPECT_EQ(refused.error().limit, limits::logins_from_one);
    EXPECT_EQ(cookie(other_link->key).find("refused"), std::string::npos);
    EXPECT_EQ(cookie_from("192.0.2.1", made->key).find("refused"), std::string::npos);
    clock.time += limits::login_proof;
    EXPECT_NE(cookie(made->key), "refused") << "in place of one that no one has used";
    EXPECT_EQ(who("cookie", never_used), std::nullopt);
    for (const std::string& each : {host, used, elsewhere})
        EXPECT_TRUE(who("cookie", each));
}

TEST_F(GateTest, LetsTheTokenInHoweverManyLogInByLinks) {
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < limits::logins / limits::logins_of_one; ++i)
        keys.push_back(grants.make("s" + std::to_string(i), Role::Viewer, {})->key);
    std::size_t refused = 0;
    for (const std::string& key : keys)
        for (std::size_t i = 0; i <= limits::logins_of_one; ++i) {
            const std::string made =
                cookie_from("192.0.2." + std::to_string(i % 8), key); // eight addresses
            who("cookie", made);
            refused += made == "refused" ? 1 : 0;
        }
    EXPECT_EQ(refused, keys.size() + limits::logins_of_one) << "the last places are the token's";
    std::vector<std::string> hosts;
    for (std::size_t i = 0; i <= limits::logins_of_one; ++i)
        hosts.push_back(cookie());
    EXPECT_EQ(who("cookie", hosts.front()), std::nullopt) << "they make room for each other";
    EXPECT_TRUE(who("cookie", hosts[1]));
    EXPECT_TRUE(who("cookie", hosts.back()));
}

TEST_F(GateTest, EndsALoginThatIsNotUsedForAWeekOrIsAMonthOld) {
    const std::string idle = cookie();
    const std::string daily = cookie();
    for (int day = 1; day < 30; ++day) {
        clock.time += std::chrono::hours(24);
        EXPECT_EQ(who("cookie", daily).has_value(), true) << day;
        if (day == 7) {
            EXPECT_EQ(who("cookie", idle), std::nullopt);
        }
    }
    clock.time += std::chrono::hours(24);
    EXPECT_EQ(who("cookie", daily), std::nullopt);
}

TEST_F(GateTest, EndsALoginWhereItsBrowserLogsOut) {
    const std::string mine = cookie();
    const std::string other = cookie();
    const HttpRequest leaving = request(
        "POST", {{"host", "localhost"}, {"origin", "http://localhost:8080"}, {"cookie", mine}});
    const Visitor early = *gate.check(leaving);
    const auto out = gate.logout(leaving);
    ASSERT_TRUE(out);
    EXPECT_EQ(out->people, std::vector<std::string>{early.person});
    EXPECT_EQ(who("cookie", mine), std::nullopt);
    EXPECT_FALSE(gate.still(early)) << "answers under way are dropped";
    EXPECT_TRUE(who("cookie", other));
    EXPECT_TRUE(gate.logout(leaving)->people.empty());
    EXPECT_FALSE(gate.logout(request("POST", {{"host", "localhost"}, {"cookie", other}})))
        << "another page may have sent it";
    EXPECT_TRUE(who("cookie", other));
}

TEST_F(GateTest, TellsPeopleOfOneLinkApartByTheirLoginOrTheirAddress) {
    const auto made = grants.make("main", Role::Viewer, {});
    const auto person = [&](const char* header, const std::string& value, std::string address) {
        HttpRequest from = request("GET", {{"host", "localhost"}, {header, value}});
        from.from = std::move(address);
        return gate.check(from)->person;
    };
    const std::string first = cookie(made->key);
    const std::string second = cookie(made->key);
    EXPECT_NE(person("cookie", first, "a"), person("cookie", second, "a"));
    EXPECT_EQ(person("cookie", first, "a"), person("cookie", first, "b"));
    const std::string bearer = "Bearer " + made->key;
    EXPECT_NE(person("authorization", bearer, "a"), person("authorization", bearer, "b"));
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
