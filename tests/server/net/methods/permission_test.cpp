// Who may call what: every method of the table, by every role, about the own session and about another one.
#include "server/net/methods/dispatcher.hpp"
#include "server/net/methods/method.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/server/no_datasets.hpp"
#include "tests/support/server/noted_wire.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server::permission_test {

using nlohmann::json;
using tests::NoDatasets;
using tests::NotedWire;

namespace {

/// What a call is about, and so what a share link is good for.
enum class About { Nothing, Session, Server };

struct Row {
    Role least;
    About about;
};

/// A new method gets its row here, or the test below fails: think about who may call it.
const std::map<std::string, Row> rows{
    {"rpc.discover", {Role::Viewer, About::Nothing}},
    {"server.info", {Role::Viewer, About::Nothing}},
    {"server.ping", {Role::Viewer, About::Nothing}},
    {"server.stats", {Role::Viewer, About::Nothing}},
    {"$/cancelRequest", {Role::Viewer, About::Nothing}},
    {"frame.ack", {Role::Viewer, About::Nothing}},
    {"time.set", {Role::Editor, About::Session}},
    {"time.play", {Role::Editor, About::Session}},
    {"time.pause", {Role::Editor, About::Session}},
    {"dataset.list", {Role::Viewer, About::Nothing}},
    {"dataset.describe", {Role::Viewer, About::Nothing}},
    {"dataset.suggest", {Role::Viewer, About::Nothing}},
    {"dataset.open", {Role::Viewer, About::Nothing}},
    {"family.make", {Role::Editor, About::Nothing}},
    {"family.remove", {Role::Editor, About::Server}}, // other sessions may show it
    {"mean.make", {Role::Editor, About::Nothing}},
    {"mean.remove", {Role::Editor, About::Server}}, // other sessions may show it
    {"cache.status", {Role::Viewer, About::Nothing}},
    {"probe.sample", {Role::Viewer, About::Nothing}},
    {"session.create", {Role::Editor, About::Server}},
    {"session.fork", {Role::Viewer, About::Session}},
    {"session.list", {Role::Viewer, About::Nothing}},
    {"session.rename", {Role::Host, About::Session}},
    {"session.setUnits", {Role::Editor, About::Session}},
    {"session.delete", {Role::Host, About::Session}},
    {"session.restore", {Role::Host, About::Server}},
    {"session.export", {Role::Viewer, About::Session}},
    {"session.import", {Role::Editor, About::Server}},
    {"session.thumbnail", {Role::Editor, About::Session}},
    {"session.join", {Role::Viewer, About::Session}},
    {"session.leave", {Role::Viewer, About::Nothing}},
    {"session.state", {Role::Viewer, About::Session}},
    {"session.share", {Role::Host, About::Session}},
    {"session.shares", {Role::Host, About::Session}},
    {"session.unshare", {Role::Host, About::Session}},
    {"session.setRole", {Role::Host, About::Session}},
    {"session.kick", {Role::Host, About::Session}},
    {"presence.update", {Role::Viewer, About::Session}},
    {"rake.set", {Role::Editor, About::Session}},
    {"rake.delete", {Role::Editor, About::Session}},
    {"rake.list", {Role::Viewer, About::Session}},
    {"surface.set", {Role::Editor, About::Session}},
    {"surface.twin", {Role::Editor, About::Session}},
    {"surface.delete", {Role::Editor, About::Session}},
    {"surface.stop", {Role::Editor, About::Session}},
    {"surface.list", {Role::Viewer, About::Session}},
    {"surface.stats", {Role::Viewer, About::Session}},
    {"surface.recipe", {Role::Viewer, About::Session}},
    {"surface.wait", {Role::Viewer, About::Session}},
    {"surface.subscribe", {Role::Viewer, About::Session}},
    {"surface.unsubscribe", {Role::Viewer, About::Nothing}},
    {"frame.ack", {Role::Viewer, About::Nothing}},
    {"time.set", {Role::Editor, About::Session}},
    {"time.play", {Role::Editor, About::Session}},
    {"time.pause", {Role::Editor, About::Session}},
    {"bookmark.set", {Role::Editor, About::Session}},
    {"bookmark.delete", {Role::Editor, About::Session}},
    {"bookmark.list", {Role::Viewer, About::Session}},
    {"slice.set", {Role::Editor, About::Session}},
    {"slice.delete", {Role::Editor, About::Session}},
    {"slice.list", {Role::Viewer, About::Session}},
    {"lines.set", {Role::Editor, About::Session}},
    {"lines.delete", {Role::Editor, About::Session}},
    {"lines.list", {Role::Viewer, About::Session}},
    {"annotation.set", {Role::Editor, About::Session}},
    {"annotation.delete", {Role::Editor, About::Session}},
    {"annotation.list", {Role::Viewer, About::Session}},
    {"history.undo", {Role::Editor, About::Session}},
    {"history.redo", {Role::Editor, About::Session}},
};

struct PermissionTest : testing::Test {
    PermissionTest() { other = (*sessions.create("other"))->id(); }

    json answer(const json& message, const Visitor& identity, Client* client) {
        std::optional<std::string> out;
        dispatcher.dispatch(message.dump(), identity, client,
                            [&](std::string text) { out = std::move(text); });
        return json::parse(out.value_or(R"({"result":"later"})"));
    }

    /// The code of the answer to a call over a WebSocket of its own, 0 for none.
    int code(const std::string& method, const Identity& identity, const json& parameters) {
        NotedWire line;
        Client client(line, identity, grants);
        return code_of(answer(call(method, parameters), identity, &client));
    }

    static json call(const std::string& method, const json& parameters = json::object()) {
        return {{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}};
    }

    static int code_of(const json& answer) {
        return answer.contains("error") ? answer["error"]["code"].get<int>() : 0;
    }

    Identity link(Role role, std::optional<std::chrono::seconds> expires_in = {}) {
        const auto made = grants.make("main", role, expires_in);
        return *grants.find(made->key);
    }

    std::vector<std::string> methods() const {
        std::vector<std::string> names;
        const json document = json::parse(dispatcher.document());
        for (const json& each : document["methods"])
            names.push_back(each["name"]);
        return names;
    }

    HandClock clock;
    HandLoop loop{clock};
    ComputePool pool{1};
    Prober prober{loop, pool};
    NoDatasets datasets;
    SystemEntropy entropy;
    Grants grants{{loop, clock, entropy, [] { return std::int64_t{0}; }}};
    SessionDirectory sessions{{loop, pool, datasets, entropy}};
    Budgets budgets{clock};
    Metrics metrics{clock};
    ServerStatus status;
    Dispatcher dispatcher{method_table(),
                          {sessions,
                           datasets,
                           [] { return json::array(); },
                           prober,
                           grants,
                           clock,
                           loop,
                           nullptr,
                           [this] { return status; },
                           &metrics,
                           nullptr,
                           {},
                           &budgets},
                          {}};
    std::string other;
};

constexpr int not_permitted = -32003;
constexpr int unauthenticated = -32001;

} // namespace

TEST_F(PermissionTest, IsAskedForEveryMethodEveryRoleAndEverySession) {
    for (const std::string& method : methods()) {
        ASSERT_TRUE(rows.contains(method)) << method << " has no row: who may call it?";
        const Row row = rows.at(method);
        for (const Role role : {Role::Viewer, Role::Editor, Role::Host})
            for (const std::string& session :
                 {std::string("main"), other, std::string("nowhere")}) {
                const json parameters =
                    row.about == About::Nothing ? json::object() : json{{"session", session}};
                const bool allowed = role >= row.least && row.about != About::Server &&
                                     (row.about == About::Nothing || session == "main");
                const Identity identity = link(role);
                // What is allowed may still lack parameters.
                EXPECT_EQ(code(method, identity, parameters) == not_permitted, !allowed)
                    << name(role) << " calls " << method << " about " << session;
                ASSERT_TRUE(grants.revoke("main", identity.grant));
            }
        for (const std::string& session : {std::string("main"), other})
            EXPECT_NE(
                code(method, {},
                     row.about == About::Nothing ? json::object() : json{{"session", session}}),
                not_permitted)
                << "the server's own token calls " << method;
    }
}

TEST_F(PermissionTest, TellsALinkTheStatisticsOfItsOwnSessionOnly) {
    status.clients = 5;
    status.caches.push_back({"secret wing", 1, 2, 3, 4});
    NotedWire there;
    Client stranger(there, {}, grants);
    for (const auto& id : {other, std::string("main")}) {
        const json joined =
            answer(call("session.join", {{"session", id}, {"name", "A"}}), {}, &stranger);
        ASSERT_TRUE(joined.contains("result")) << joined;
    }
    const json all = answer(call("server.stats"), {}, nullptr)["result"];
    EXPECT_EQ(all["clients"], 5);
    EXPECT_EQ(all["cache"][0]["dataset"], "secret wing");
    for (const Role role : {Role::Viewer, Role::Host}) {
        const Identity identity = link(role);
        const json own = answer(call("server.stats"), identity, nullptr)["result"];
        std::vector<std::string> told;
        for (const auto& [name, value] : own.items())
            told.push_back(name);
        EXPECT_EQ(told,
                  (std::vector<std::string>{"firstFrame", "participants", "stages", "surfaces"}));
        EXPECT_EQ(own["participants"], 1) << "who has left the other session for this one";
    }
    ASSERT_TRUE(answer(call("session.join", {{"session", other}, {"name", "A"}}), {}, &stranger)
                    .contains("result"));
    EXPECT_EQ(answer(call("server.stats"), link(Role::Viewer), nullptr)["result"]["participants"],
              0);
}

TEST_F(PermissionTest, CountsALongAnswerInTheRateOfItsCaller) {
    const Identity viewer = link(Role::Viewer);
    std::size_t answered = 0;
    while (answered < 200 && code_of(answer(call("rpc.discover"), viewer, nullptr)) == 0)
        ++answered;
    EXPECT_LT(answered, 200u) << "of short ones there are 4,000 at once";
    EXPECT_EQ(code_of(answer(call("server.ping"), viewer, nullptr)), -32014);
    EXPECT_EQ(code_of(answer(call("server.ping"), link(Role::Viewer), nullptr)), 0);
}

TEST_F(PermissionTest, SaysWhichRoleIsNeeded) {
    const Identity viewer = link(Role::Viewer);
    NotedWire line;
    Client client(line, viewer, grants);
    const json error = answer(call("rake.set", {{"session", "main"}}), viewer, &client)["error"];
    EXPECT_EQ(error["data"]["kind"], "notPermitted");
    EXPECT_NE(error["data"]["hint"].get<std::string>().find("editor"), std::string::npos);
}

TEST_F(PermissionTest, ForWhatIsEverybodysAsksForTheRoleOfTheLinkThatTheMakerOfACopyCameBy) {
    const json velocity{{"dataset", "any"}, {"velocity", "U"}};
    for (const Role role : {Role::Viewer, Role::Editor}) {
        const Identity first = link(role);
        const auto made = grants.make_for_copy(other, {first.grant, "Ada"});
        const auto further = grants.make_for_copy(other, {made->grant.id, "Ada"});
        for (const std::string& key : {made->key, further->key}) {
            const Identity own = *grants.find(key);
            ASSERT_EQ(own.role, Role::Editor);
            NotedWire line;
            Client client(line, own, grants);
            ASSERT_EQ(code_of(answer(call("session.join"), own, &client)), 0);
            EXPECT_NE(code_of(answer(call("rake.set"), own, &client)), not_permitted);
            for (const auto& [method, parameters] :
                 {std::pair<const char*, json>{"family.make", json::object()},
                  {"dataset.open", velocity}}) {
                EXPECT_EQ(code_of(answer(call(method, parameters), own, &client)) == not_permitted,
                          role == Role::Viewer)
                    << method << " by the copy of a link of a " << name(role);
                EXPECT_EQ(code_of(answer(call(method, parameters), own, nullptr)) == not_permitted,
                          role == Role::Viewer)
                    << method;
            }
        }
    }
}

TEST_F(PermissionTest, NeverTellsALinkWhetherThereIsAnotherSession) {
    const Identity host = link(Role::Host);
    const auto refusal = [&](const std::string& session) {
        NotedWire line;
        Client client(line, host, grants);
        return answer(call("session.state", {{"session", session}}), host, &client);
    };
    EXPECT_EQ(refusal(other), refusal("nowhere"));
    const json list = answer(call("session.list"), host, nullptr)["result"]["sessions"];
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0]["session"], "main");
    EXPECT_EQ(answer(call("session.list"), {}, nullptr)["result"]["sessions"].size(), 2u);
}

TEST_F(PermissionTest, IsAskedAgainForEachCallOfABatch) {
    const Identity host = link(Role::Host);
    json batch = json::array();
    for (const json& each :
         {call("rake.list"), call("session.unshare", {{"grant", host.grant}}), call("rake.list")})
        batch.push_back(each);
    const json answers = answer(batch, host, nullptr);
    EXPECT_EQ(code_of(answers[0]), 0) << "a link needs not say its session";
    EXPECT_EQ(code_of(answers[1]), 0);
    EXPECT_EQ(code_of(answers[2]), unauthenticated);
}

TEST_F(PermissionTest, EndsWithTheLinkAndClosesItsConnections) {
    const Identity taken_back = link(Role::Editor);
    const Identity expiring = link(Role::Editor, std::chrono::seconds(5));
    NotedWire first_line;
    NotedWire second_line;
    Client first(first_line, taken_back, grants);
    Client second(second_line, expiring, grants);
    const json join = call("session.join", {{"session", "main"}});
    EXPECT_EQ(code_of(answer(join, taken_back, &first)), 0);
    EXPECT_EQ(code_of(answer(join, expiring, &second)), 0);
    EXPECT_EQ(
        code_of(answer(call("session.unshare", {{"session", "main"}, {"grant", taken_back.grant}}),
                       {}, nullptr)),
        0);
    EXPECT_EQ(first_line.closed, Goodbye::LinkEnded);
    EXPECT_EQ(first_line.sent.back()["method"], "server.notice");
    EXPECT_EQ(code_of(answer(call("rake.list"), taken_back, &first)), unauthenticated);
    EXPECT_EQ(second_line.closed, std::nullopt);
    loop.advance(std::chrono::seconds(5));
    EXPECT_EQ(second_line.closed, Goodbye::LinkEnded);
    EXPECT_TRUE((*sessions.find("main"))->participants().present().empty());
    NotedWire late_line;
    const Client late(late_line, expiring, grants); // let in before, upgraded after the end
    EXPECT_EQ(late_line.closed, Goodbye::LinkEnded);
}

TEST_F(PermissionTest, FollowsTheRoleAHostSetsForAParticipant) {
    const Identity viewer = link(Role::Viewer);
    NotedWire line;
    Client client(line, viewer, grants);
    const json joined =
        answer(call("session.join", {{"session", "main"}}), viewer, &client)["result"];
    EXPECT_EQ(joined["role"], "viewer");
    const auto make = [&](const char* role) {
        return code_of(
            answer(call("session.setRole",
                        {{"session", "main"}, {"participant", joined["you"]}, {"role", role}}),
                   {}, nullptr));
    };
    EXPECT_EQ(code_of(answer(call("history.undo"), viewer, &client)), not_permitted);
    EXPECT_EQ(make("editor"), 0);
    EXPECT_EQ(code_of(answer(call("history.undo"), viewer, &client)), 0);
    EXPECT_EQ(code_of(answer(call("session.state", {{"session", other}}), viewer, &client)),
              not_permitted);
    EXPECT_EQ(make("viewer"), 0);
    EXPECT_EQ(code_of(answer(call("history.undo"), viewer, &client)), not_permitted);
    EXPECT_EQ(make("king"), -32602);
}

TEST_F(PermissionTest, HoldsALesserRoleForEveryWayThatPersonsLinkOffers) {
    const Visitor by_link(link(Role::Editor), "login 1");
    const Visitor elsewhere(by_link, "login 2");
    const json join = call("session.join", {{"session", "main"}});
    const json undo = call("history.undo", {{"session", "main"}});
    NotedWire lines[5];
    Client demoted(lines[0], by_link, grants);
    Client second_window(lines[1], by_link, grants);
    Client colleague(lines[2], elsewhere, grants);
    Client unjoined(lines[3], by_link, grants);
    const json you = answer(join, by_link, &demoted)["result"];
    const json second = answer(join, by_link, &second_window)["result"]["you"];
    const json theirs = answer(join, elsewhere, &colleague)["result"];
    EXPECT_EQ(code_of(answer(undo, by_link, &unjoined)), 0);
    const auto set_role = [&](const char* role) {
        return answer(call("session.setRole",
                           {{"session", "main"}, {"participant", you["you"]}, {"role", role}}),
                      {}, nullptr)["result"];
    };
    const json set = set_role("viewer");
    EXPECT_EQ(set["also"], json::array({second}));
    EXPECT_EQ(set["newcomers"], "viewer");
    EXPECT_EQ(code_of(answer(undo, by_link, &demoted)), not_permitted);
    EXPECT_EQ(code_of(answer(undo, by_link, &second_window)), not_permitted);
    EXPECT_EQ(code_of(answer(undo, by_link, &unjoined)), not_permitted) << "a socket without place";
    EXPECT_EQ(code_of(answer(undo, by_link, nullptr)), not_permitted) << "HTTP";
    answer(call("session.leave"), by_link, &demoted);
    EXPECT_EQ(code_of(answer(undo, by_link, &demoted)), not_permitted) << "after leaving";
    EXPECT_EQ(answer(join, by_link, &demoted)["result"]["role"], "viewer") << "a new place";
    EXPECT_EQ(code_of(answer(undo, by_link, &demoted)), not_permitted);
    const auto rejoin = [&](Client& client, const Visitor& as, const json& token) {
        return answer(call("session.join", {{"session", "main"}, {"resumeToken", token}}), as,
                      &client)["result"]["role"];
    };
    EXPECT_EQ(rejoin(demoted, by_link, you["resumeToken"]), "viewer") << "the old place";
    EXPECT_EQ(code_of(answer(undo, elsewhere, &colleague)), 0) << "who is another person";
    EXPECT_EQ(rejoin(colleague, elsewhere, theirs["resumeToken"]), "editor");
    Client anew(lines[4], elsewhere, grants);
    EXPECT_EQ(answer(join, elsewhere, &anew)["result"]["role"], "viewer")
        << "another login may be the same person";
    EXPECT_FALSE(set_role("editor").contains("newcomers"));
    EXPECT_EQ(code_of(answer(undo, by_link, nullptr)), 0);
}

TEST_F(PermissionTest, RaisesOnePlaceOnly) {
    const Identity viewer = link(Role::Viewer);
    NotedWire lines[2];
    Client raised(lines[0], viewer, grants);
    Client other_socket(lines[1], viewer, grants);
    const json you =
        answer(call("session.join", {{"session", "main"}}), viewer, &raised)["result"]["you"];
    answer(call("session.setRole", {{"session", "main"}, {"participant", you}, {"role", "editor"}}),
           {}, nullptr);
    const json undo = call("history.undo", {{"session", "main"}});
    EXPECT_EQ(code_of(answer(undo, viewer, &raised)), 0);
    EXPECT_EQ(code_of(answer(undo, viewer, &other_socket)), not_permitted);
    EXPECT_EQ(code_of(answer(undo, viewer, nullptr)), not_permitted);
}

TEST_F(PermissionTest, TellsWhoMadeALinkAndOffersToEndWhatItMade) {
    const auto share = [&](const Identity& by, json more = json::object()) {
        more["session"] = "main";
        more["role"] = "host";
        return answer(call("session.share", more), by, nullptr);
    };
    const json first = share({}, {{"expiresIn", nullptr}})["result"];
    EXPECT_FALSE(first.contains("expires")) << "for ever, on purpose";
    EXPECT_FALSE(first["madeBy"].contains("grant"));
    const Identity by_first = *grants.find(first["key"].get<std::string>());
    const json week = share(by_first)["result"];
    EXPECT_EQ(week["expires"], 7 * 24 * 3600);
    EXPECT_EQ(week["madeBy"]["grant"], first["grant"]);
    const Identity by_week = *grants.find(week["key"].get<std::string>());
    clock.time += std::chrono::hours(24);
    EXPECT_EQ(share(by_week)["result"]["expires"], 6 * 24 * 3600) << "not beyond its maker's link";
    EXPECT_EQ(code_of(share(by_week, {{"expiresIn", nullptr}})), -32602);
    const json shares =
        answer(call("session.shares", {{"session", "main"}}), {}, nullptr)["result"]["shares"];
    ASSERT_EQ(shares.size(), 3u);
    EXPECT_EQ(shares[0]["children"], 2);
    EXPECT_EQ(shares[1]["children"], 1);
    const auto unshare = [&](const json& grant, bool children) {
        return answer(call("session.unshare",
                           {{"session", "main"}, {"grant", grant}, {"children", children}}),
                      {}, nullptr)["result"]["children"];
    };
    const json alive = unshare(week["grant"], false);
    ASSERT_EQ(alive.size(), 1u);
    EXPECT_EQ(alive[0]["madeBy"]["grant"], week["grant"]);
    EXPECT_TRUE(unshare(first["grant"], true).empty());
    EXPECT_TRUE(grants.of("main").empty());
}

TEST_F(PermissionTest, KeepsLinksFromLordingItOverTheServersOwnToken) {
    const Identity host = link(Role::Host);
    NotedWire owners_line;
    NotedWire guests_line;
    Client owner(owners_line, {}, grants);
    Client guest(guests_line, host, grants);
    const json join = call("session.join", {{"session", "main"}});
    const json owner_id = answer(join, {}, &owner)["result"]["you"];
    const json guest_id = answer(join, host, &guest)["result"]["you"];
    const auto kick = [&](const json& who, const Identity& by, Client& from) {
        return code_of(answer(call("session.kick", {{"participant", who}}), by, &from));
    };
    EXPECT_EQ(kick(owner_id, host, guest), not_permitted);
    EXPECT_EQ(
        code_of(answer(call("session.setRole", {{"participant", owner_id}, {"role", "viewer"}}),
                       host, &guest)),
        not_permitted);
    EXPECT_EQ(kick("p99", {}, owner), -32004);
    EXPECT_EQ(kick(guest_id, {}, owner), 0);
    EXPECT_EQ(guests_line.closed, Goodbye::Removed);
    EXPECT_EQ(owners_line.closed, std::nullopt);
}

TEST_F(PermissionTest, TakesCallsNoFasterThanAPersonMayOverAllTheirConnections) {
    const json edit = call("rake.delete", {{"session", "main"}, {"rake", "r9"}});
    const Visitor editor(link(Role::Editor), "login 1");
    const Visitor another(editor, "login 2");
    NotedWire lines[2];
    Client first(lines[0], editor, grants);
    Client second(lines[1], editor, grants);
    const auto limited = [&](const Visitor& identity, Client* client) {
        int count = 0;
        for (int i = 0; i < 200; ++i) {
            const json out = answer(edit, identity, client);
            if (code_of(out) != -32014)
                continue;
            ++count;
            EXPECT_EQ(out["error"]["data"]["retryAfterMs"], 5);
            EXPECT_EQ(out["error"]["data"]["limit"], 200);
        }
        return count;
    };
    EXPECT_EQ(limited(editor, &first) + limited(editor, &second), 0);
    EXPECT_EQ(limited(editor, nullptr), 200) << "400 at once, whichever way";
    EXPECT_EQ(limited(another, nullptr), 0) << "another person";
    EXPECT_EQ(limited({}, nullptr), 0) << "the server's own token";
    EXPECT_EQ(code_of(answer(call("rake.list", {{"session", "main"}}), editor, nullptr)), 0);
    clock.time += std::chrono::milliseconds(5);
    EXPECT_EQ(code_of(answer(edit, editor, &first)), -32004);
}

} // namespace wakesurf::server::permission_test
