// Several people in one session, over real sockets: share links from the link to its end, presence, and coming back.
#include "tests/support/server/shared_session.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace wakesurf::tests::sharing_test {

using nlohmann::json;

namespace {

constexpr unsigned displaced = 4001;
constexpr unsigned removed = 4002;
constexpr unsigned link_ended = 4003;
constexpr unsigned logged_out = 4004;

class Sharing : public SharedSession {
  protected:
    /// What a client is told of somebody, once that says `member`.
    static json news_of(WebSocketClient& client, const json& participant, const char* member) {
        for (;;) {
            const json news = client.notification("presence.patched");
            for (const json& each : news["participants"])
                if (each["participant"] == participant && !each.value(member, json()).is_null())
                    return each;
        }
    }

    int rpc_status(const Headers& headers) const {
        return http(server.port(), "POST", "/rpc", headers,
                    R"({"jsonrpc":"2.0","id":1,"method":"server.ping"})")
            .status;
    }
};

} // namespace

TEST_F(Sharing, TakesALinkWhereverItTakesTheTokenAndInItsRoleOnly) {
    const json made = share("viewer");
    const std::string key = made["key"];
    EXPECT_EQ(made["link"], "#session=main&token=" + key);
    EXPECT_TRUE(made.contains("expires"));
    const Headers bearer = with_key(key);
    EXPECT_EQ(rpc_status(bearer), 200);
    EXPECT_EQ(http(server.port(), "GET", "/openrpc.json", bearer).status, 200);
    EXPECT_EQ(http(server.port(), "GET", "/api/v1/sessions/session-1/surfaces/s1/mesh.vtp", bearer)
                  .status,
              403);
    EXPECT_EQ(
        http(server.port(), "GET", "/api/v1/sessions/main/surfaces/s1/mesh.vtp", bearer).status,
        404);
    WebSocketClient viewer(server, "main", bearer);
    EXPECT_EQ(viewer.call("rake.set", rake(1))["error"]["code"], -32003);
    EXPECT_TRUE(viewer.result("rake.list")["rakes"].empty());

    // As the page does it: the key out of the link's fragment for a login.
    const HttpReply login = http(server.port(), "POST", "/api/v1/login",
                                 {{"Origin", server.origin()}}, json{{"token", key}}.dump());
    ASSERT_EQ(login.status, 200);
    const json got = json::parse(login.body);
    EXPECT_EQ(got["session"], "main");
    EXPECT_EQ(got["login"].get<std::string>().find(key), std::string::npos);
    WebSocketClient browser(server, "main", with_key(got["login"]));
    EXPECT_EQ(browser.call("rake.set", rake(1))["error"]["code"], -32003);
    const json shares = host.result("session.shares")["shares"];
    ASSERT_EQ(shares.size(), 1u);
    EXPECT_EQ(shares[0]["grant"], made["grant"]);
    EXPECT_EQ(shares[0]["role"], "viewer");
    EXPECT_EQ(shares[0]["madeBy"], json({{"name", "guest 1"}}));
    EXPECT_FALSE(shares[0].contains("key"));
}

TEST_F(Sharing, LogsABrowserOutWithItsSocketsAndNobodyElse) {
    const json made = share("viewer");
    const Headers page{{"Origin", server.origin()}};
    const auto log_in = [&] {
        const HttpReply login =
            http(server.port(), "POST", "/api/v1/login", page, json{{"token", made["key"]}}.dump());
        return with_key(json::parse(login.body)["login"]);
    };
    const Headers mine = log_in();
    const Headers theirs = log_in();
    WebSocketClient window(server, "main", mine);
    WebSocketClient unjoined(server, "", mine);
    WebSocketClient other(server, "main", theirs);
    Headers foreign = mine;
    foreign.emplace_back("Origin", "http://localhost:1");
    EXPECT_EQ(http(server.port(), "POST", "/api/v1/logout", foreign).status, 403);
    EXPECT_EQ(http(server.port(), "GET", "/api/v1/logout", mine).status, 405);
    EXPECT_EQ(rpc_status(mine), 200);
    const HttpReply out = http(server.port(), "POST", "/api/v1/logout", mine);
    EXPECT_EQ(out.status, 200);
    EXPECT_EQ(json::parse(out.body), json({{"durable", true}}));
    EXPECT_EQ(close_code(window), logged_out);
    EXPECT_EQ(close_code(unjoined), logged_out);
    EXPECT_EQ(rpc_status(mine), 401);
    EXPECT_EQ(rpc_status(theirs), 200);
    EXPECT_EQ(other.result("server.ping"), json::object());
    EXPECT_EQ(http(server.port(), "POST", "/api/v1/logout", page).status, 200)
        << "nothing to end is no error";
}

TEST_F(Sharing, DisconnectsEverybodyWhoCameByALinkThatIsTakenBack) {
    const json made = share("editor");
    const std::string key = made["key"];
    const Headers bearer = with_key(key);
    WebSocketClient joined(server, "main", bearer);
    WebSocketClient not_joined(server, "", bearer);
    WebSocketClient another(server, "main", with_key(share("editor")["key"]));
    joined.result("rake.set", rake(1));
    host.result("session.unshare", {{"grant", made["grant"]}});
    EXPECT_EQ(close_code(joined), link_ended);
    EXPECT_EQ(close_code(not_joined), link_ended);
    EXPECT_EQ(rpc_status(bearer), 401);
    EXPECT_EQ(another.result("server.ping"), json::object());
    EXPECT_EQ(host.call("session.unshare", {{"grant", made["grant"]}})["error"]["code"], -32004);
}

TEST_F(Sharing, DisconnectsThemWhenTheLinkExpires) {
    const json made = share("viewer", {{"expiresIn", 1}});
    EXPECT_TRUE(made["expires"].is_number_integer());
    WebSocketClient viewer(server, "main", with_key(made["key"]));
    EXPECT_EQ(close_code(viewer), link_ended);
    EXPECT_EQ(rpc_status(with_key(made["key"])), 401);
}

TEST_F(Sharing, AnswersNoWaitOfALinkThatHasEnded) {
    const json made = share("viewer");
    host.result("rake.set", rake(1));
    const json surface = host.result(
        "surface.set",
        {{"rake", "r1"}, {"kind", "stream"}, {"dataset", "lamb-oseen"}, {"from", 0}, {"to", 1}});
    RawSocket waiting(server.port());
    const std::string body =
        json{{"jsonrpc", "2.0"},
             {"id", 1},
             {"method", "surface.wait"},
             {"params", {{"surface", surface["surface"]}, {"epoch", 99}, {"timeoutMs", 300}}}}
            .dump();
    waiting.send("POST /rpc HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer " +
                 made["key"].get<std::string>() +
                 "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
    host.result(
        "server.ping"); // behind the request on its way, most likely; either way the answer is 401
    host.result("session.unshare", {{"grant", made["grant"]}});
    EXPECT_EQ(read_reply(waiting).status, 401);
}

TEST_F(Sharing, KeepsKeysOutOfTheLog) {
    const json made = share("host");
    const std::string key = made["key"];
    {
        WebSocketClient guest(server, "main", with_key(key));
        guest.result("session.share", {{"role", "viewer"}});
        guest.call("session.share", {{"role", key}});
        guest.call("session.unshare", {{"grant", key}});
    }
    http(server.port(), "POST", "/api/v1/login", {{"Origin", server.origin()}},
         json{{"token", key}}.dump());
    http(server.port(), "GET", "/" + key, with_key(key));
    host.result("session.unshare", {{"grant", made["grant"]}});
    EXPECT_EQ(rpc_status(with_key(key)), 401);
    EXPECT_EQ(server.stop().log.find(key), std::string::npos);
}

TEST_F(Sharing, ShowsTwoPeopleToEachOther) {
    const json mine = host.result("session.join", {{"session", "main"}, {"name", "Ada"}});
    WebSocketClient guest(server, "", with_key(share("viewer")["key"]));
    const json theirs =
        guest.result("session.join", {{"session", "main"}, {"name", "Bob"}, {"colour", "#123456"}});
    ASSERT_EQ(theirs["participants"].size(), 2u);
    EXPECT_EQ(theirs["role"], "viewer");
    const json come = news_of(host, theirs["you"], "name");
    EXPECT_EQ(come["name"], "Bob");
    EXPECT_EQ(come["colour"], "#123456");
    EXPECT_EQ(come["role"], "viewer");
    const json camera{{"position", {0.0, 0.0, 5.0}},
                      {"target", {0.0, 0.0, 0.0}},
                      {"up", {0.0, 1.0, 0.0}},
                      {"fov", 45.0}};
    guest.send({{"jsonrpc", "2.0"},
                {"method", "presence.update"},
                {"params", {{"pointer", {1.0, 2.0, 3.0}}, {"camera", camera}}}});
    const json moved = news_of(host, theirs["you"], "pointer");
    EXPECT_EQ(
        moved,
        (json{{"participant", theirs["you"]}, {"pointer", {1.0, 2.0, 3.0}}, {"camera", camera}}));
    host.result("presence.update", {{"dragging", {{"rake", "r1"}, {"points", {{0.0, 1.0, 2.0}}}}},
                                    {"selected", "r1"}});
    const json dragged = news_of(guest, mine["you"], "dragging");
    EXPECT_EQ(dragged["selected"], "r1");
    EXPECT_EQ(dragged["dragging"]["points"], (json::array({{0.0, 1.0, 2.0}})));
    guest.result("session.leave");
    json left;
    while (left.empty())
        left = host.notification("presence.patched")["left"];
    EXPECT_EQ(left, json::array({theirs["you"]}));
}

TEST_F(Sharing, RefusesPresenceThatIsNone) {
    for (const auto& [member, value] :
         std::map<std::string, json>{{"pointer", {1, 2}},
                                     {"pointer ", {1, 2, 3}},
                                     {"camera", {{"position", {0, 0, 0}}, {"target", {0, 0, 1}}}},
                                     {"camera2", json::object()},
                                     {"dragging", "r1"},
                                     {"selected", 7}})
        EXPECT_EQ(host.call("presence.update", {{member, value}})["error"]["code"], -32602)
            << member;
    EXPECT_EQ(host.call("presence.update", {{"pointer", {1e300, 0, 0}}})["error"]["code"], -32602);
    EXPECT_EQ(host.call("presence.update", {{"selected", std::string(65, 'r')}})["error"]["code"],
              -32602);
    EXPECT_EQ(host.result("presence.update", {{"pointer", nullptr}}), json::object());
    WebSocketClient nowhere(server, "");
    EXPECT_EQ(nowhere.call("presence.update", {{"session", "main"}})["error"]["code"], -32602);
}

TEST_F(Sharing, GivesWhoeverComesBackWhatWasMissedAndItIsWhatTheOthersHave) {
    host.result("rake.set", rake(1));
    json joined;
    std::map<std::string, json> records; // as the page keeps them
    {
        WebSocketClient guest(server, "");
        joined = guest.result("session.join", {{"session", "main"}, {"name", "Bob"}});
        EXPECT_EQ(joined["resumed"], false);
        for (const json& each : joined["snapshot"]["rakes"])
            records[each["rake"]] = each;
        guest.socket().reset();
    }
    for (int i = 0; i < 20; ++i) {
        json edit = rake(i % 5);
        edit["rake"] = "r1";
        host.result("rake.set", edit);
    }
    host.result("rake.set", rake(2));
    host.result("rake.set", rake(3));
    host.result("rake.delete", {{"rake", "r2"}});

    WebSocketClient back(server, "");
    const json again = back.result(
        "session.join",
        {{"session", "main"}, {"resumeToken", joined["resumeToken"]}, {"lastSeq", joined["seq"]}});
    EXPECT_EQ(again["you"], joined["you"]);
    EXPECT_EQ(again["resumed"], true);
    EXPECT_FALSE(again.contains("snapshot"));
    EXPECT_EQ(again["patches"].size(), 3u) << "of each record the newest";
    for (const json& each : again["patches"])
        if (each["op"] == "put")
            records[each["id"]] = each["record"];
        else
            records.erase(each["id"]);
    std::map<std::string, json> theirs;
    const json list = host.result("rake.list");
    for (const json& each : list["rakes"])
        theirs[each["rake"]] = each;
    EXPECT_EQ(records, theirs);

    const json unknown = back.result(
        "session.join",
        {{"session", "main"}, {"resumeToken", std::string(32, '0')}, {"lastSeq", joined["seq"]}});
    EXPECT_EQ(unknown["resumed"], false);
    EXPECT_EQ(unknown["snapshot"]["rakes"].size(), 2u);
}

TEST_F(Sharing, TellsTheOlderOfTwoConnectionsInOnePlaceAndClosesIt) {
    WebSocketClient older(server, "");
    const json joined = older.result("session.join", {{"session", "main"}});
    WebSocketClient newer(server, "");
    const json again =
        newer.result("session.join", {{"session", "main"}, {"resumeToken", joined["resumeToken"]}});
    EXPECT_EQ(again["you"], joined["you"]);
    EXPECT_EQ(older.notification("server.notice")["kind"], "displaced");
    EXPECT_EQ(close_code(older), displaced);
    EXPECT_EQ(newer.result("session.state")["participants"].size(), 2u);
}

TEST_F(Sharing, LetsAHostSendSomebodyAway) {
    WebSocketClient guest(server, "", with_key(share("editor")["key"]));
    const json joined = guest.result("session.join", {{"session", "main"}});
    EXPECT_EQ(guest.call("session.kick", {{"participant", joined["you"]}})["error"]["code"],
              -32003);
    host.result("session.kick", {{"participant", joined["you"]}});
    EXPECT_EQ(guest.notification("server.notice")["kind"], "removed");
    EXPECT_EQ(close_code(guest), removed);
    EXPECT_EQ(host.result("session.state")["participants"].size(), 1u);
}

TEST_F(Sharing, RefusesNamesAndColoursThatAreNone) {
    const auto code = [&](json parameters) {
        parameters["session"] = "main";
        return host.call("session.join", parameters).value("error", json{{"code", 0}})["code"];
    };
    EXPECT_EQ(code({{"name", "a\nb"}}), -32602);
    EXPECT_EQ(code({{"name", std::string(121, 'a')}}), -32602);
    EXPECT_EQ(code({{"colour", "red"}}), -32602);
    EXPECT_EQ(code({{"colour", "#12345g"}}), -32602);
    EXPECT_EQ(code({{"lastSeq", -1}}), -32602);
    EXPECT_EQ(host.call("session.share", {{"role", "viewer"}, {"expiresIn", 0}})["error"]["code"],
              -32602);
    EXPECT_EQ(host.call("session.share", {{"role", "owner"}})["error"]["code"], -32602);
    EXPECT_EQ(code({{"name", "\u202eAda"}}), 0);
    const json state = host.result("session.state");
    EXPECT_EQ(state["participants"][0]["name"], "Ada");
}

} // namespace wakesurf::tests::sharing_test
