// Sessions as calls see them: listed, renamed, deleted, brought back, pictured; who is told, and what the errors say.
#include "server/base/limits.hpp"
#include "server/net/methods/dispatcher.hpp"
#include "server/net/methods/method.hpp"
#include "server/sessions/session_exchange.hpp"
#include "tests/support/server/noted_wire.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>

namespace wakesurf::server::session_methods_test {

using nlohmann::json;
using tests::NotedWire;
using tests::SessionBench;

namespace {

/// The smallest PNG there is: one pixel.
const std::string pixel =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg"
    "==";

struct SessionMethods : testing::Test {
    json answer(const std::string& method,
                const json& parameters = json::object(),
                const Identity& identity = {},
                Client* client = nullptr) {
        bench.loop.pass(std::chrono::milliseconds(5)); // not faster than calls may come
        json out;
        dispatcher.dispatch(
            json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}}.dump(),
            identity, client, [&out](const std::string& text) { out = json::parse(text); });
        return out;
    }

    json result(const std::string& method, const json& parameters = json::object()) {
        json out = answer(method, parameters);
        EXPECT_TRUE(out.contains("result")) << out;
        return out["result"];
    }

    json error(const std::string& method, const json& parameters) {
        json out = answer(method, parameters);
        EXPECT_TRUE(out.contains("error")) << out;
        return out["error"];
    }

    json entry(const std::string& session, bool trash = false) {
        const json list = result("session.list", {{"trash", trash}});
        for (const json& each : list["sessions"])
            if (each["session"] == session)
                return each;
        return nullptr;
    }

    SessionBench bench;
    Grants grants{
        {bench.loop, bench.loop, bench.entropy, [this] { return bench.wall; }, &bench.journal}};
    Prober prober{bench.loop, bench.pool};
    Dispatcher dispatcher{method_table(),
                          {bench.sessions, bench.datasets, [] { return json::array(); }, prober,
                           grants, bench.loop, bench.loop, &bench.journal},
                          {}};
    const json line{{"kind", "line"}, {"points", {{0, 0, 0}, {1, 0, 0}}}, {"seeds", 8}};
};

} // namespace

TEST_F(SessionMethods, AListTellsWhoWasHereWhenAndWhatIsInASession) {
    const std::string id = result("session.create", {{"name", "wake"}})["session"];
    NotedWire wire;
    Client ada(wire, {}, grants);
    const json joined =
        answer("session.join", {{"session", id}, {"name", "Ada"}, {"colour", "#102030"}}, {}, &ada);
    EXPECT_EQ(joined["result"]["created"], "2027-01-15T08:00:00Z");
    json setting = line;
    setting["session"] = id;
    result("rake.set", setting);
    const json now = entry(id);
    EXPECT_EQ(now["participants"], 1);
    EXPECT_EQ(now["people"], json::parse(R"([{"name":"Ada","colour":"#102030"}])"));
    EXPECT_EQ(now["rakes"], 1);
    EXPECT_EQ(now["surfaces"], 0);
    EXPECT_EQ(now["edited"], true);
    EXPECT_EQ(now["thumbnail"], false);
    EXPECT_EQ(now["created"], "2027-01-15T08:00:00Z");
    bench.wall += 3600;
    EXPECT_EQ(entry(id)["lastUsed"], "2027-01-15T09:00:00Z") << "she is here";
    ada.leave();
    bench.wall += 3600;
    EXPECT_EQ(entry(id)["lastUsed"], "2027-01-15T09:00:00Z");
    EXPECT_EQ(entry(id)["participants"], 0);
}

TEST_F(SessionMethods, UnitsThatAreTypedAreToldToAllAndGoWithTheSession) {
    const std::string id = result("session.create", {{"name", "wake"}})["session"];
    EXPECT_FALSE(result("session.state", {{"session", id}}).contains("units"));
    NotedWire wire;
    Client ada(wire, {}, grants);
    answer("session.join", {{"session", id}, {"name", "Ada"}, {"colour", "#102030"}}, {}, &ada);
    const json units{{"length", "mm"}, {"time", "s"}};
    // Nothing in it that turns the writing direction, as in names.
    const json set =
        result("session.setUnits", {{"session", id}, {"length", " m\u202em "}, {"time", "s"}});
    EXPECT_EQ(set, (json{{"session", id}, {"name", "wake"}, {"units", units}, {"durable", true}}));
    EXPECT_EQ(result("session.state", {{"session", id}})["units"], units);
    std::string told;
    for (const json& each : wire.sent)
        told += each.dump();
    EXPECT_NE(told.find(R"("units":{"length":"mm","time":"s"})"), std::string::npos) << told;
    // A new name leaves them.
    result("session.rename", {{"session", id}, {"name", "lee"}});
    EXPECT_EQ(result("session.state", {{"session", id}})["units"], units);
    const std::string copy = result("session.fork", {{"session", id}})["session"];
    EXPECT_EQ(result("session.state", {{"session", copy}})["units"], units);
    const json file = result("session.export", {{"session", id}})["file"];
    const std::string twin = result("session.import", {{"file", file}})["session"];
    EXPECT_EQ(result("session.state", {{"session", twin}})["units"], units);
    result("session.setUnits", {{"session", id}, {"length", ""}, {"time", ""}});
    EXPECT_FALSE(result("session.state", {{"session", id}}).contains("units"));
    error("session.setUnits", {{"session", id}, {"length", std::string(33, 'm')}, {"time", ""}});
}

TEST_F(SessionMethods, JoiningWithoutASessionIsJoiningMainOrTheLinksOwn) {
    NotedWire wire;
    Client host(wire, {}, grants);
    answer("session.join", json::object(), {}, &host);
    EXPECT_EQ(host.session()->id(), "main");
    const std::string id = result("session.create")["session"];
    const Identity link = *grants.find(grants.make(id, Role::Viewer, {})->key);
    Client guest(wire, link, grants);
    answer("session.join", json::object(), link, &guest);
    EXPECT_EQ(guest.session()->id(), id);
}

TEST_F(SessionMethods, OverTheLimitTheErrorSaysHowManyAndWhatToDo) {
    std::size_t remaining = result("session.create", {{"name", "a"}})["remaining"];
    EXPECT_EQ(remaining, limits::kept_sessions - 2);
    for (; remaining > 0; --remaining)
        EXPECT_EQ(result("session.create", {{"name", "a"}})["remaining"], remaining - 1);
    const json refused = error("session.create", {{"name", "a"}});
    EXPECT_EQ(refused["code"], -32014);
    EXPECT_EQ(refused["data"]["limit"], limits::kept_sessions);
    EXPECT_NE(refused["data"]["hint"].get<std::string>().find("session.export"), std::string::npos);
    EXPECT_EQ(result("session.list")["sessions"].size(), limits::kept_sessions);
    EXPECT_EQ(result("session.list")["limit"], limits::kept_sessions);
}

TEST_F(SessionMethods, EverybodyIsToldOfANewNameAlsoWhoComesBack) {
    NotedWire wire;
    Client ada(wire, {}, grants);
    const json joined = answer("session.join", {{"session", "main"}}, {}, &ada)["result"];
    ada.leave();
    EXPECT_EQ(
        result("session.rename", {{"session", "main"}, {"name", " our\u202e  wake "}})["name"],
        "our wake");
    const json back = answer(
        "session.join",
        {{"session", "main"}, {"resumeToken", joined["resumeToken"]}, {"lastSeq", joined["seq"]}},
        {}, &ada)["result"];
    EXPECT_EQ(back["patches"], json::parse(R"([{"op":"put","type":"session","id":"main",
                                  "record":{"session":"main","name":"our wake"}}])"));
    result("session.rename", {{"session", "main"}, {"name", "again"}});
    EXPECT_EQ(wire.sent.back()["params"]["patches"][0]["record"]["name"], "again");
    EXPECT_EQ(error("session.rename", {{"session", "main"}, {"name", " "}})["code"], -32602);
}

TEST_F(SessionMethods, DeletingTellsThePeopleAndTakesThemOut) {
    const std::string id = result("session.create", {{"name", "short"}})["session"];
    NotedWire wire;
    Client ada(wire, {}, grants);
    answer("session.join", {{"session", id}}, {}, &ada);
    const json gone = result("session.delete", {{"session", id}});
    EXPECT_EQ(gone["deletedUntil"], "2027-02-14T08:00:00Z");
    EXPECT_EQ(wire.sent.back()["method"], "server.notice");
    EXPECT_EQ(wire.sent.back()["params"]["kind"], "sessionDeleted");
    EXPECT_FALSE(wire.closed) << "she may join another";
    EXPECT_EQ(ada.session(), nullptr);
    EXPECT_EQ(entry(id), nullptr);
    EXPECT_EQ(entry(id, true)["deletedUntil"], gone["deletedUntil"]);
    EXPECT_EQ(entry(id, true)["deletedAt"], "2027-01-15T08:00:00Z");
    EXPECT_EQ(error("session.state", {{"session", id}})["code"], -32004);
    EXPECT_EQ(result("session.restore", {{"session", id}})["name"], "short");
    EXPECT_EQ(entry(id)["name"], "short");
    EXPECT_EQ(error("session.restore", {{"session", id}})["code"], -32004);
}

TEST_F(SessionMethods, AHostByALinkGetsTheAnswerAndThenLosesTheLinkUntilTheSessionIsBack) {
    const std::string id = result("session.create", {{"name", "linked"}})["session"];
    const std::string key = grants.make(id, Role::Host, {})->key;
    const Identity link = *grants.find(key);
    NotedWire wire;
    Client host(wire, link, grants);
    const json gone = answer("session.delete", {{"session", id}}, link, &host);
    EXPECT_TRUE(gone.contains("result")) << gone;
    EXPECT_EQ(wire.closed, Goodbye::LinkEnded);
    EXPECT_FALSE(grants.find(key));
    result("session.restore", {{"session", id}});
    EXPECT_TRUE(grants.find(key));
}

TEST_F(SessionMethods, OnlyTheTrashIsEmptiedForGoodAndMainStays) {
    const std::string id = result("session.create", {{"name", "x"}})["session"];
    const json forever{{"session", id}, {"forever", true}};
    EXPECT_EQ(error("session.delete", forever)["code"], -32602);
    result("session.delete", {{"session", id}});
    EXPECT_EQ(error("session.delete", {{"session", id}})["code"], -32004);
    result("session.delete", forever);
    EXPECT_EQ(entry(id, true), nullptr);
    EXPECT_EQ(error("session.delete", forever)["code"], -32004);
    const json refused = error("session.delete", {{"session", "main"}});
    EXPECT_EQ(refused["code"], -32602);
    EXPECT_FALSE(refused["data"]["hint"].get<std::string>().empty());
}

TEST_F(SessionMethods, AThumbnailIsAPictureOrIsRefused) {
    const auto send = [&](const std::string& image) {
        return answer("session.thumbnail", {{"session", "main"}, {"image", image}});
    };
    EXPECT_TRUE(send(pixel).contains("result"));
    EXPECT_EQ(entry("main")["thumbnail"], true);
    EXPECT_EQ(entry("main")["edited"], false);
    for (const std::string& wrong : {std::string(), std::string("!!!!"), std::string("PHN2Zy8+"),
                                     pixel + "\n", std::string("data:image/png;base64,") + pixel})
        EXPECT_EQ(send(wrong)["error"]["code"], -32602) << wrong;
    EXPECT_EQ(send(std::string(limits::thumbnail_bytes / 3 * 4 + 4, 'A'))["error"]["code"], -32014);
    SessionBench after;
    after.sessions.restore("main", "main", bench.journal.entries("main"));
    EXPECT_EQ(after.session->thumbnail(), pixel);
}

TEST_F(SessionMethods, TheDefaultSceneIsNoEdit) {
    json setting = line;
    setting["session"] = "main";
    setting["default"] = true;
    const std::string rake = result("rake.set", setting)["rake"];
    EXPECT_EQ(error("rake.set", setting)["code"], -32602);
    const json surface{{"session", "main"}, {"rake", rake}, {"dataset", "abc"}, {"kind", "stream"},
                       {"from", 0},         {"to", 1},      {"default", true}};
    result("surface.set", surface);
    EXPECT_EQ(entry("main")["edited"], false);
    setting.erase("default");
    result("rake.set", setting);
    EXPECT_EQ(entry("main")["edited"], true);
}

} // namespace wakesurf::server::session_methods_test
