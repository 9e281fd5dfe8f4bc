// Copies of a session, above all those that holders of share links make: what becomes of them, and how many there may be.
#include "server/base/limits.hpp"
#include "tests/support/server/shared_session.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace wakesurf::tests::copies_test {

using nlohmann::json;

namespace {

constexpr unsigned link_ended = 4003;

using Copies = SharedSession;

} // namespace

TEST_F(Copies, ForksASessionWithItsRecords) {
    host.result("rake.set", rake(1));
    const json fork = host.result("session.fork", {{"session", "main"}, {"name", "copy\u202e"}});
    EXPECT_NE(fork["session"], "main");
    const json state = host.result("session.state", {{"session", fork["session"]}});
    EXPECT_EQ(state["name"], "copy");
    EXPECT_EQ(state["rakes"][0]["points"], host.result("session.state")["rakes"][0]["points"]);
    EXPECT_TRUE(state["participants"].empty());
}

TEST_F(Copies, LetsAViewerContinueInACopyAtTheTimeThatIsShown) {
    host.result("rake.set", rake(1));
    host.result("time.set", {{"time", 0.25}});
    const json viewers = share("viewer");
    WebSocketClient guest(server, "", with_key(viewers["key"]));
    guest.result("session.join", {{"session", "main"}, {"name", "Ada"}});
    EXPECT_EQ(guest.call("time.play", {{"from", 0}, {"to", 1}})["error"]["code"], -32003);
    const json made = guest.result("session.fork", {{"name", "main copy"}});
    EXPECT_EQ(made["link"], "#session=" + made["session"].get<std::string>() +
                                "&token=" + made["key"].get<std::string>());

    WebSocketClient own(server, "", with_key(made["key"]));
    const json joined = own.result("session.join");
    EXPECT_EQ(joined["role"], "editor");
    EXPECT_EQ(joined["copyOf"], (json{{"session", "main"}, {"name", "main"}}));
    EXPECT_EQ(joined["snapshot"]["clock"]["time"], 0.25);
    own.result("time.play", {{"from", 0}, {"to", 1}});
    own.result("rake.set", rake(2));
    const json shown = host.result("session.state");
    EXPECT_EQ(shown["clock"]["time"], 0.25) << "nobody else sees any of it";
    EXPECT_EQ(shown["rakes"].size(), 1u);

    EXPECT_EQ(own.call("session.share", {{"role", "viewer"}})["error"]["code"], -32003);
    EXPECT_EQ(own.call("session.state", {{"session", "main"}})["error"]["code"], -32003);
    EXPECT_EQ(guest.call("session.fork", {{"session", made["session"]}})["error"]["code"], -32003);
    EXPECT_EQ(guest.call("session.state", {{"session", made["session"]}})["error"]["code"], -32003)
        << "a key lets into one session only";
}

TEST_F(Copies, EndsCopiesWithTheLinkTheyWereMadeBy) {
    const json viewers = share("viewer");
    WebSocketClient guest(server, "", with_key(viewers["key"]));
    guest.result("session.join", {{"session", "main"}, {"name", "Ada"}});
    const json made = guest.result("session.fork");
    WebSocketClient own(server, "", with_key(made["key"]));
    own.result("session.join");
    EXPECT_EQ(host.result("session.shares")["shares"][0]["children"], 1);
    const json unshared = host.result("session.unshare", {{"grant", viewers["grant"]}});
    EXPECT_EQ(unshared["children"], json::array());
    EXPECT_EQ(close_code(own), link_ended);
    const json asked{{"jsonrpc", "2.0"}, {"id", 1}, {"method", "session.state"}};
    EXPECT_EQ(http(server.port(), "POST", "/rpc", with_key(made["key"]), asked.dump()).status, 401);
}

TEST_F(Copies, ThatNobodyChangedMakeRoomForOthers) {
    const json viewers = share("viewer");
    const Headers key = with_key(viewers["key"]);
    const auto copy = [&] {
        return json::parse(http(server.port(), "POST", "/rpc", key,
                                R"({"jsonrpc":"2.0","id":1,"method":"session.fork"})")
                               .body);
    };
    const json first = copy()["result"];
    const auto change = [&](const json& made) {
        WebSocketClient own(server, "", with_key(made["key"]));
        own.result("session.join");
        own.result("rake.set", rake(1));
    };
    change(first);
    for (std::size_t i = 1; i < server::limits::copies_by_link; ++i)
        ASSERT_TRUE(copy().contains("result")) << i;
    const json one_more = copy()["result"];
    EXPECT_EQ(host.result("session.list")["sessions"].size(), server::limits::copies_by_link + 1);
    EXPECT_TRUE(host.call("session.state", {{"session", first["session"]}}).contains("result"))
        << "somebody's work stays";
    change(one_more);
    const json list = host.result("session.list")["sessions"];
    for (const json& each : list) {
        json of = rake(1);
        of["session"] = each["session"];
        host.result("rake.set", of);
    }
    EXPECT_EQ(copy()["error"]["code"], -32014);
    EXPECT_EQ(copy()["error"]["data"]["limit"], server::limits::copies_by_link);
    EXPECT_TRUE(host.call("session.fork").contains("result")) << "for the token there is room";
}

TEST_F(Copies, ThatWereChangedLeaveAShareToTheHoldersOfOtherLinks) {
    constexpr std::size_t links = server::limits::copies_by_links / server::limits::copies_by_link;
    const auto copy = [&](const Headers& key) {
        return json::parse(http(server.port(), "POST", "/rpc", key,
                                R"({"jsonrpc":"2.0","id":1,"method":"session.fork"})")
                               .body);
    };
    std::size_t fewest = server::limits::copies_by_link;
    for (std::size_t link = 0; link < links; ++link) {
        const Headers key = with_key(share("viewer")["key"]);
        std::size_t made = 0;
        for (json one = copy(key); one.contains("result"); one = copy(key), ++made) {
            json of = rake(1);
            of["session"] = one["result"]["session"];
            host.result("rake.set", of);
        }
        fewest = std::min(fewest, made);
    }
    EXPECT_GE(fewest, 8u);
    EXPECT_TRUE(copy(with_key(share("viewer")["key"])).contains("result"));
}

TEST_F(Copies, AreDeletedByWhoMadeThemByALinkAsLongAsTheyAreNobodysWork) {
    const json viewers = share("viewer");
    const Headers link = with_key(viewers["key"]);
    const auto call = [&](const Headers& key, const std::string& method, const json& of) {
        return json::parse(
            http(server.port(), "POST", "/rpc", key,
                 json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", of}}.dump())
                .body);
    };
    const auto copy = [&] { return call(link, "session.fork", json::object())["result"]; };
    const auto sessions = [&](bool trash) {
        return host.result("session.list", {{"trash", trash}})["sessions"].size();
    };
    const json one = copy();
    const json other = copy();
    const json of_one{{"session", one["session"]}};
    EXPECT_EQ(call(link, "session.delete", of_one)["error"]["code"], -32003)
        << "not by the first link";
    EXPECT_EQ(call(with_key(other["key"]), "session.delete", of_one)["error"]["code"], -32003)
        << "nor by that into another copy";
    EXPECT_EQ(call(link, "session.delete", {{"session", "main"}})["error"]["code"], -32003);
    const Headers own = with_key(one["key"]);
    call(own, "time.set", {{"session", one["session"]}, {"time", 1}});
    {
        WebSocketClient me(server, "", own);
        me.result("session.join");
        host.result("session.join", of_one);
        EXPECT_EQ(call(own, "session.delete", of_one)["error"]["code"], -32003)
            << "the host is in it";
        host.result("session.leave");
        const json gone = call(own, "session.delete", of_one);
        EXPECT_EQ(gone["result"], of_one) << gone;
    }
    EXPECT_EQ(sessions(false), 2u);
    EXPECT_EQ(sessions(true), 0u) << "it is not in the trash";
    EXPECT_EQ(call(own, "session.state", of_one)["error"]["code"], -32001) << "its link has ended";
    const json of_other{{"session", other["session"]}};
    json edit = rake(1);
    edit["session"] = other["session"];
    call(with_key(other["key"]), "rake.set", edit);
    EXPECT_EQ(call(with_key(other["key"]), "session.delete", of_other)["error"]["code"], -32003);
    const json shared = copy();
    host.result("session.share", {{"session", shared["session"]}, {"role", "viewer"}});
    const json of_shared{{"session", shared["session"]}};
    EXPECT_EQ(call(with_key(shared["key"]), "session.delete", of_shared)["error"]["code"], -32003);
    EXPECT_EQ(sessions(false), 3u);
}

TEST_F(Copies, LeavesNoCopyBehindThatNobodyCouldEnter) {
    std::string key = share("viewer")["key"];
    std::size_t copies = 0;
    for (;; ++copies) {
        ASSERT_LT(copies, 20u);
        WebSocketClient guest(server, "", with_key(key));
        const json made = guest.call("session.fork");
        if (made.contains("error")) {
            EXPECT_EQ(made["error"]["code"], -32014) << "a copy of a copy of a copy";
            break;
        }
        key = made["result"]["key"];
    }
    EXPECT_EQ(host.result("session.list")["sessions"].size(), copies + 1);
}

} // namespace wakesurf::tests::copies_test
