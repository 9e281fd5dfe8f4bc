// The methods on a session's records, over the transports scripts and people use: bookmarks, annotations, leases, undo.
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace wakesurf::tests::document_methods_test {

using nlohmann::json;

namespace {

class DocumentMethods : public ServerSuite {
  protected:
    static json http(const std::string& method, json parameters) {
        parameters["session"] = "main";
        return json::parse(server_->rpc(
            json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}}
                .dump()));
    }

    static json rake_at(double z, const std::string& rake = "") {
        json out{{"kind", "line"}, {"points", {{0.5, 0.0, z}, {2.0, 0.0, z}}}, {"seeds", 6}};
        if (!rake.empty())
            out["rake"] = rake;
        return out;
    }

    static json with(json object, const std::string& name, json value) {
        object[name] = std::move(value);
        return object;
    }

    /// The next patch of one record type, as told to this client.
    static json patch_of(WebSocketClient& client, const std::string& type) {
        for (;;) {
            const json told = client.notification("session.patched");
            for (const json& each : told["patches"])
                if (each["type"] == type)
                    return each;
        }
    }
};

} // namespace

TEST_F(DocumentMethods, ABookmarkIsSetListedToldAndDeleted) {
    WebSocketClient client(*server_);
    const json view{{"camera", {{"eye", {1.5, 2, 3}}}}, {"colour", "speed"}};
    const json made =
        client.result("bookmark.set", {{"name", "overview"}, {"view", view}, {"time", 2.5}});
    EXPECT_EQ(made["rev"], 1);
    const json patch = patch_of(client, "bookmark");
    const json record{{"bookmark", made["bookmark"]},
                      {"rev", 1},
                      {"name", "overview"},
                      {"view", view},
                      {"time", 2.5}};
    EXPECT_EQ(patch["op"], "put");
    EXPECT_EQ(patch["record"], record);
    EXPECT_EQ(client.result("bookmark.list")["bookmarks"], json::array({record}));
    EXPECT_EQ(client.result("session.state")["bookmarks"], json::array({record}));
    const json stale = client.call(
        "bookmark.set", {{"bookmark", made["bookmark"]}, {"view", json::object()}, {"ifRev", 7}});
    EXPECT_EQ(stale["error"]["code"], -32801);
    EXPECT_EQ(stale["error"]["data"]["current"], record);
    EXPECT_EQ(client.call("bookmark.delete",
                          {{"bookmark", made["bookmark"]}, {"ifRev", 7}})["error"]["code"],
              -32801);
    client.result("bookmark.delete", {{"bookmark", made["bookmark"]}, {"ifRev", 1}});
    EXPECT_EQ(client.result("bookmark.list")["bookmarks"], json::array());
}

TEST_F(DocumentMethods, AnAnnotationIsDataHoweverHostileItsText) {
    WebSocketClient client(*server_, "");
    client.result("session.join", {{"session", "main"}, {"name", "Ada"}});
    const std::string text = "<img src=x onerror=alert(1)>\n\"'; DROP TABLE records; -- {{7*7}}";
    // What turns the writing direction goes.
    const json made =
        client.result("annotation.set", {{"text", text + "\u202e"}, {"position", {0.1, 0.2, 0.3}}});
    const json record = patch_of(client, "annotation")["record"];
    EXPECT_EQ(record["text"], text);
    EXPECT_EQ(record["author"], "Ada");
    EXPECT_EQ(client.result("annotation.list")["annotations"], json::array({record}));
    for (const json& wrong :
         {json{{"text", "bell \a"}, {"position", {0, 0, 0}}}, json{{"text", "t"}},
          json{{"text", 5}, {"position", {0, 0, 0}}},
          json{{"text", "t"}, {"position", {0, 0, 1e39}}},
          json{{"text", std::string(5000, 'x')}, {"position", {0, 0, 0}}},
          json{{"text", "t"}, {"position", {0, 0, 0}}, {"author", "someone else"}}})
        EXPECT_EQ(client.call("annotation.set", wrong)["error"]["code"], -32602) << wrong;
    EXPECT_EQ(
        client.call("annotation.set",
                    {{"text", "t"}, {"position", {0, 0, 0}}, {"surface", "s99"}})["error"]["code"],
        -32004);
    client.result("annotation.delete", {{"annotation", made["annotation"]}});
}

TEST_F(DocumentMethods, AViewIsAnObjectOfFewBytes) {
    WebSocketClient client(*server_);
    for (const json& view : {json("text"), json(nullptr), json::array({1}), json(3),
                             json{{"long", std::string(4096, 'x')}}})
        EXPECT_EQ(client.call("bookmark.set", {{"view", view}})["error"]["code"], -32602) << view;
    EXPECT_EQ(client.result("bookmark.list")["bookmarks"], json::array());
}

TEST_F(DocumentMethods, ARakeSomebodyDragsIsTheirsUntilTheyLetGo) {
    WebSocketClient ada(*server_);
    WebSocketClient bob(*server_);
    const json rake = ada.result("rake.set", rake_at(0))["rake"];
    ada.result("rake.set", with(rake_at(0.1, rake), "dragging", true));
    const json error = bob.call("rake.set", rake_at(0.2, rake))["error"];
    EXPECT_EQ(error["code"], -32011);
    EXPECT_EQ(error["data"]["kind"], "leased");
    EXPECT_EQ(error["data"]["by"], bob.result("rake.list")["rakes"][0]["leasedBy"]);
    EXPECT_GT(error["data"]["untilMs"], 0);
    EXPECT_LE(error["data"]["untilMs"], 5000);
    EXPECT_EQ(error["data"]["until"].get<std::string>().size(), 24u) << error;
    EXPECT_EQ(bob.call("rake.delete", {{"rake", rake}})["error"]["code"], -32011);
    EXPECT_EQ(http("rake.set", rake_at(0.2, rake))["error"]["code"], -32011)
        << "a script waits like everyone";
    bob.result("rake.set", with(rake_at(0.3, rake), "force", true));
    EXPECT_EQ(ada.result("rake.list")["rakes"][0]["dragging"], false);
    ada.result("rake.set", with(rake_at(0.4, rake), "dragging", true));
    ada.result("rake.set", with(rake_at(0.5, rake), "dragging", false));
    bob.result("rake.delete", {{"rake", rake}});
}

TEST_F(DocumentMethods, ALeaseEndsWithItsHoldersConnection) {
    WebSocketClient bob(*server_);
    const json rake = bob.result("rake.set", rake_at(0))["rake"];
    {
        WebSocketClient ada(*server_);
        ada.result("rake.set", with(rake_at(0.1, rake), "dragging", true));
        ada.socket().reset();
    }
    const auto told = [&](bool dragging) {
        return patch_of(bob, "rake")["record"]["dragging"] == dragging;
    };
    while (!told(true)) // the patch of the rake's creation comes first
        ;
    while (!told(false))
        ;
    EXPECT_FALSE(bob.result("rake.list")["rakes"][0].contains("leasedBy"));
    bob.result("rake.delete", {{"rake", rake}});
}

TEST_F(DocumentMethods, AScriptOverHttpUndoesItsOwnEdits) {
    WebSocketClient person(*server_);
    const json rake = http("rake.set", rake_at(0))["result"]["rake"];
    const json moved = http("rake.set", rake_at(0.5, rake))["result"];
    person.result("rake.set", rake_at(2.0));
    const json undone = http("history.undo", json::object())["result"];
    EXPECT_EQ(undone["undone"],
              json::array({{{"op", "put"}, {"type", "rake"}, {"id", rake}, {"rev", 3}}}));
    EXPECT_EQ(undone["skipped"], json::array());
    EXPECT_EQ(undone["redo"], 1);
    EXPECT_EQ(person.result("session.state")["seq"], undone["seq"]);
    person.result("rake.set", rake_at(0.7, rake));
    const json skipped = http("history.redo", json::object())["result"];
    EXPECT_EQ(skipped["redone"], nullptr);
    EXPECT_EQ(skipped["skipped"][0]["id"], rake);
    EXPECT_EQ(person.result("history.undo")["undone"][0]["id"], rake);
    EXPECT_EQ(person.result("history.undo")["undone"][0]["op"], "delete");
    EXPECT_EQ(person.result("history.undo")["undone"], nullptr);
    person.result("rake.delete", {{"rake", rake}});
}

TEST_F(DocumentMethods, EditsOfOneGestureAreUndoneTogether) {
    WebSocketClient client(*server_);
    const auto in_gesture = [](json parameters) {
        return with(std::move(parameters), "gesture", "press 1");
    };
    const json rake = client.result("rake.set", in_gesture(rake_at(0)))["rake"];
    const json setting{{"rake", rake}, {"kind", "stream"}, {"dataset", "lamb-oseen"}, {"from", 0}};
    const json surface =
        client.result("surface.set", in_gesture(with(setting, "to", 0.5)))["surface"];
    const json note = client.result(
        "annotation.set", in_gesture({{"text", "t"}, {"position", {0, 0, 0}}}))["annotation"];
    const json bookmark =
        client.result("bookmark.set", in_gesture({{"view", json::object()}}))["bookmark"];
    const json state = client.result("session.state");
    client.result("rake.set", rake_at(1, rake));
    const json more = in_gesture(with(with(setting, "surface", surface), "to", 0.25));
    for (int i = 0; i < 120; ++i)
        client.result("surface.set", more);
    EXPECT_EQ(client.result("history.undo")["undo"], 2);
    EXPECT_EQ(client.result("surface.list")["surfaces"][0]["to"], 0.5);
    EXPECT_EQ(client.result("history.undo")["undone"].size(), 1u);
    EXPECT_EQ(client.result("history.undo")["undone"].size(), 4u);
    EXPECT_EQ(client.result("rake.list")["rakes"], json::array());
    EXPECT_EQ(client.result("history.redo")["redone"].size(), 4u);
    const json again = client.result("session.state");
    for (const char* type : {"rakes", "surfaces", "slices", "lines", "bookmarks", "annotations"})
        EXPECT_EQ(again[type].size(), state[type].size());
    client.result("annotation.delete", in_gesture({{"annotation", note}}));
    client.result("bookmark.delete", in_gesture({{"bookmark", bookmark}}));
    client.result("surface.delete", in_gesture({{"surface", surface}}));
    client.result("rake.delete", in_gesture({{"rake", rake}}));
    EXPECT_EQ(client.result("history.undo")["undone"].size(), 4u) << "a redo ended the first press";
    client.result("rake.delete", {{"rake", rake}});
    client.result("annotation.delete", {{"annotation", note}});
    client.result("bookmark.delete", {{"bookmark", bookmark}});
}

TEST_F(DocumentMethods, AGestureIsAShortText) {
    WebSocketClient client(*server_);
    for (const json& gesture : {json(""), json(7), json("bell \a"), json(std::string(65, 'g'))}) {
        const json error = client.call("rake.set", with(rake_at(0), "gesture", gesture))["error"];
        EXPECT_EQ(error["code"], -32602) << gesture;
        EXPECT_NE(error["message"].get<std::string>().find("`gesture`"), std::string::npos);
    }
    EXPECT_EQ(client.result("rake.list")["rakes"], json::array());
    const json rake =
        client.result("rake.set", with(rake_at(0), "gesture", std::string(64, 'g')))["rake"];
    client.result("rake.delete", {{"rake", rake}});
}

TEST_F(DocumentMethods, ADeletionCanDependOnTheRevision) {
    WebSocketClient client(*server_);
    const json rake = client.result("rake.set", rake_at(0));
    const json surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                       {"kind", "stream"},
                                                       {"dataset", "lamb-oseen"},
                                                       {"from", 0},
                                                       {"to", 0.5}});
    const auto code = [&](const std::string& method, const json& parameters) {
        const json answer = client.call(method, parameters);
        return answer.contains("error") ? answer["error"]["code"].get<int>() : 0;
    };
    EXPECT_EQ(code("surface.delete", {{"surface", surface["surface"]}, {"ifRev", 9}}), -32801);
    EXPECT_EQ(code("rake.delete", {{"rake", rake["rake"]}, {"ifRev", 9}}), -32801);
    EXPECT_EQ(code("surface.delete", {{"surface", surface["surface"]}, {"ifRev", 1}}), 0);
    EXPECT_EQ(code("rake.delete", {{"rake", rake["rake"]}, {"ifRev", 1}}), 0);
    EXPECT_EQ(code("rake.delete", {{"rake", rake["rake"]}, {"ifRev", 1}}), -32004);
}

TEST_F(DocumentMethods, ATwinIsSetAloneKeptByOtherEditsAndTakenBack) {
    const std::string rake = http("rake.set", rake_at(0.5))["result"]["rake"];
    const json setting{{"rake", rake},
                       {"dataset", "lamb-oseen"},
                       {"kind", "stream"},
                       {"to", 2.0},
                       {"separation", 0.2}};
    const std::string surface = http("surface.set", setting)["result"]["surface"];
    const auto record = [&] {
        const json list = http("surface.list", json::object());
        for (const json& each : list["result"]["surfaces"])
            if (each["surface"] == surface)
                return each;
        return json();
    };
    const json twin{{"accuracy", "exact"}, {"offset", {0.0, 0.0, 0.25}}};
    const json before = record();
    EXPECT_EQ(http("surface.twin", {{"surface", surface}, {"twin", twin}})["result"]["rev"], 2);
    json expected = before;
    expected["twin"] = twin;
    expected["rev"] = 2;
    expected["epoch"] = record()["epoch"];
    EXPECT_EQ(record(), expected);
    const json waited =
        http("surface.wait", {{"surface", surface}, {"timeoutMs", 30000}, {"checked", true}});
    const json& stats = waited["result"];
    EXPECT_FALSE(stats.contains("intervalPending"));
    EXPECT_NEAR(stats["twin"]["all"]["p50"], 0.25, 1e-4);
    EXPECT_EQ(stats["twin"]["all"]["compared"], 1.0);

    EXPECT_EQ(http("surface.twin", {{"surface", surface},
                                    {"twin", {{"dataset", "other"}}}})["error"]["data"]["kind"],
              "notFound");
    EXPECT_EQ(http("surface.twin", {{"surface", surface}})["result"]["rev"], 3);
    EXPECT_FALSE(record().contains("twin"));
}

} // namespace wakesurf::tests::document_methods_test
