#include "server/limits.hpp"
#include "server/net/gate.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

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
    Gate gate{{token, "127.0.0.1", 8080, {"https://viewer.example", "http://lab:9000"}},
              entropy,
              clock,
              grants};

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
        const auto identity = gate.check(request("GET", {{"host", "localhost"}, {header, value}}));
        return identity ? std::optional(*identity) : std::nullopt;
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
        {"127.0.0.2", 403},
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
        {"http://localhost", 403},
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
    const Identity early = *who("cookie", second);
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

TEST_F(GateTest, ForgetsTheOldestCookieOfWhoeverLogsInTooOften) {
    const auto made = grants.make("main", Role::Viewer, {});
    const std::string host = cookie();
    const std::string oldest = cookie(made->key);
    const std::string next = cookie(made->key);
    for (std::size_t i = 1; i < limits::cookies_of_one; ++i)
        cookie(made->key);
    EXPECT_EQ(who("cookie", oldest), std::nullopt);
    EXPECT_TRUE(who("cookie", next));
    EXPECT_TRUE(who("cookie", host));
}

TEST_F(GateTest, TakesEverybodyForAHostWhereThereIsNoAuthentication) {
    Gate open{{{}, "127.0.0.1", 8080, {}}, entropy, clock, grants};
    EXPECT_EQ(open.check(request("GET", {{"host", "localhost"}})), Identity{});
    EXPECT_FALSE(open.check(request("GET", {{"host", "evil.example"}})));
}

TEST(Loopback, IsWhatOnlyThisMachineReaches) {
    for (const char* host : {"localhost", "127.0.0.1", "127.8.8.8", "::1", "[::1]", "LocalHost"})
        EXPECT_TRUE(is_loopback(host)) << host;
    for (const char* host :
         {"0.0.0.0", "::", "192.168.0.1", "127.evil.example", "localhost.example", "127.0.0"})
        EXPECT_FALSE(is_loopback(host)) << host;
}

} // namespace wakesurf::server
