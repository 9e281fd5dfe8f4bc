// What Set-Cookie says of where a login's cookie goes: path, TLS, frames.
#include "server/net/gate.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server::cookie_text_test {

namespace {

const std::string token(64, 'a');

struct CookieText : testing::Test {
    static HttpRequest request(std::string method,
                               std::vector<std::pair<std::string, std::string>> headers) {
        HttpRequest out;
        out.method = std::move(method);
        out.headers = std::move(headers);
        return out;
    }

    SystemEntropy entropy;
    HandClock clock;
    HandLoop loop{clock};
    Grants grants{{loop, clock, entropy, [] { return std::int64_t{0}; }}};
    Gate gate{{token, "127.0.0.1", 8080, {"https://viewer.example", "http://lab:9000"}},
              entropy,
              clock,
              grants};
};

} // namespace

TEST_F(CookieText, GivesThePageBehindAPrefixACookieForThatPathAlone) {
    const auto value = gate.login(request("POST", {{"host", "lab"}}), token, "/flow/");
    ASSERT_TRUE(value);
    EXPECT_NE(value->find("; Path=/flow/"), std::string::npos) << *value;
    HttpRequest leaving =
        request("POST", {{"host", "lab"}, {"origin", "http://lab:9000"}, {"cookie", *value}});
    leaving.headers.back().second = value->substr(0, value->find(';'));
    const auto out = gate.logout(leaving, "/flow/");
    ASSERT_TRUE(out);
    EXPECT_NE(out->cookie.find("; Path=/flow/"), std::string::npos) << out->cookie;
    EXPECT_EQ(out->people.size(), 1u);
}

TEST_F(CookieText, TellsServersBesideEachOtherBelowOneNameApartByTheirPaths) {
    Gate other{
        {"another-token", "127.0.0.1", 8080, {"https://viewer.example"}}, entropy, clock, grants};
    const auto login = [](Gate& to, const std::string& secret, const char* path) {
        return *to.login(request("POST", {{"host", "viewer.example"}}), secret, path);
    };
    const std::string first = login(gate, token, "/a/");
    const std::string second = login(other, "another-token", "/b/");
    EXPECT_NE(first.substr(first.find("Path")), second.substr(second.find("Path")));
    // One of them at the root: the browser sends both cookies to the other, in any order.
    const auto text = [](const std::string& cookie) { return cookie.substr(0, cookie.find(';')); };
    for (const std::string& both :
         {text(first) + "; " + text(second), text(second) + "; " + text(first)}) {
        const HttpRequest asking = request("GET", {{"host", "viewer.example"}, {"cookie", both}});
        EXPECT_TRUE(gate.check(asking)) << both;
        EXPECT_TRUE(other.check(asking)) << both;
    }
}

TEST(CookiePath, IsWhatACookieMaySay) {
    for (const char* path : {"/", "/flow/", "/user/ada/proxy/8080/", "/a%20b/~c/"})
        EXPECT_TRUE(is_cookie_path(path)) << path;
    const std::string longest(513, '/');
    for (const std::string& path :
         {std::string(), std::string("flow/"), std::string("/flow"), std::string("/a; Domain=x/"),
          std::string("/a\r\nSet-Cookie: b/"), std::string("/a b/"), std::string("/\xc3\xa4/"),
          longest})
        EXPECT_FALSE(is_cookie_path(path)) << path;
}

TEST_F(CookieText, KeepsTheCookieToTlsWhereverTlsEnds) {
    const auto value = [&](const char* origin) {
        return *gate.login(request("POST", {{"host", "viewer.example"}, {"origin", origin}}),
                           token);
    };
    EXPECT_NE(value("https://viewer.example").find("; Secure"), std::string::npos);
    EXPECT_EQ(value("http://lab:9000").find("; Secure"), std::string::npos);
}

TEST_F(CookieText, GivesAPageInAFrameACookieForThatFrameOnlyOverTls) {
    Gate framed{
        {token, "127.0.0.1", 8080, {"https://viewer.example"}, false, nullptr, unix_seconds, true},
        entropy,
        clock,
        grants};
    const auto value = [&](const char* origin) {
        return *framed.login(request("POST", {{"host", "viewer.example"}, {"origin", origin}}),
                             token);
    };
    EXPECT_NE(value("https://viewer.example").find("SameSite=None; Partitioned"),
              std::string::npos);
    EXPECT_NE(value("http://localhost:8080").find("SameSite=Strict"), std::string::npos);
    const auto usual = gate.login(
        request("POST", {{"host", "viewer.example"}, {"origin", "https://viewer.example"}}), token);
    ASSERT_TRUE(usual);
    EXPECT_EQ(usual->find("None"), std::string::npos);
}

} // namespace wakesurf::server::cookie_text_test
