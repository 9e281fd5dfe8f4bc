// The session's clock and the frames that follow it, over a real socket: two clients fold what they are sent.
#include "protocol/wire/mesh_decoder.hpp"
#include "store/store_generation.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace wakesurf::tests::time_methods_test {

using nlohmann::json;

namespace {

class TimeMethods : public testing::Test {
  protected:
    static void SetUpTestSuite() { server_ = new ServerProcess({"flow:oscillating"}); }

    static void TearDownTestSuite() { delete server_; }

    TimeMethods() : client(*server_, "") {
        session = client.result("session.create")["session"];
        client.result("session.join", {{"session", session}});
        const json rake = client.result(
            "rake.set", {{"kind", "line"}, {"points", {{-5, 0, 0}, {-5, 1, 0}}}, {"seeds", 5}});
        surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                {"kind", "streak"},
                                                {"dataset", "oscillating"},
                                                {"from", 0},
                                                {"to", 4},
                                                {"separation", 0.2}})["surface"];
    }

    json wait(WebSocketClient& by) {
        return by.result("surface.wait", {{"surface", surface}, {"timeoutMs", 60'000}});
    }

    /// Folds frames until a whole state that `wanted` takes.
    static const protocol::DecodedState&
    fold_until(WebSocketClient& client,
               protocol::MeshDecoder& decoder,
               const std::function<bool(const protocol::FrameHeader&)>& wanted) {
        for (;;) {
            const auto folded = decoder.fold(client.frame());
            if (!folded)
                throw std::runtime_error(folded.error().message);
            if (*folded && wanted(decoder.newest()->header))
                return *decoder.newest();
        }
    }

    json refused(const std::string& method, const json& parameters) {
        const json answer = client.call(method, parameters);
        return answer.contains("error") ? answer["error"] : json("was not refused");
    }

    /// Of /metrics.
    static int counted(const std::string& name) {
        const std::string text = http(server_->port(), "GET", "/metrics", server_->bearer()).body;
        const auto at = text.find("\n" + name + " ");
        return at == std::string::npos ? -1 : std::stoi(text.substr(at + name.size() + 2));
    }

    static ServerProcess* server_;
    WebSocketClient client;
    std::string session, surface;
};

ServerProcess* TimeMethods::server_ = nullptr;

bool is_final(const protocol::FrameHeader& header) {
    return header.phase == protocol::Phase::Final;
}

} // namespace

TEST_F(TimeMethods, PlaysAStreakToAStateWhoseChecksumIsTheServers) {
    client.result("surface.subscribe", {{"surface", surface}});
    protocol::MeshDecoder decoder;
    // In a loop: on a busy machine the end may come before the second frame.
    const json clock = client.result("time.play", {{"speed", 4}, {"loop", true}})["clock"];
    EXPECT_EQ(clock["playing"], true);
    const double seen = fold_until(client, decoder, [](const auto& header) {
                            return header.phase == protocol::Phase::Live && header.time > 0.5;
                        }).header.time;
    fold_until(client, decoder, [&](const auto& header) { return header.time != seen; });
    const json paused = client.result("time.pause")["clock"];
    EXPECT_EQ(paused["playing"], false);
    const json stats = wait(client);
    EXPECT_EQ(stats["complete"], true);
    const auto state = fold_until(client, decoder, is_final);
    EXPECT_DOUBLE_EQ(state.header.time, paused["time"].get<double>());
    EXPECT_EQ(state.header.state_sum, stats["stateSum"].get<std::uint32_t>());
    EXPECT_EQ(protocol::state_sum(*state.mesh), stats["stateSum"].get<std::uint32_t>());
    EXPECT_EQ(state.mesh->cells().size(), stats["quads"].get<std::size_t>());
}

TEST_F(TimeMethods, StopsByItselfAtTheEndAndTellsEverybody) {
    WebSocketClient other(*server_, session);
    client.result("time.play", {{"speed", 40}});
    json patch = other.notification("session.patched")["patches"][0];
    EXPECT_EQ(patch["type"], "clock");
    EXPECT_EQ(patch["record"]["playing"], true);
    EXPECT_EQ(patch["record"]["from"], 0.0);
    EXPECT_EQ(patch["record"]["to"], 4.0);
    patch = other.notification("session.patched")["patches"][0];
    EXPECT_EQ(patch["record"]["playing"], false);
    EXPECT_EQ(patch["record"]["time"], 4.0);
    EXPECT_EQ(other.result("session.state")["clock"], patch["record"]);
}

TEST_F(TimeMethods, GoesBackToTheEndWhenTheTimeIsForgotten) {
    const json whole = wait(client);
    client.result("time.set", {{"time", 1.0}});
    EXPECT_LT(wait(client)["quads"], whole["quads"]);
    EXPECT_EQ(client.result("time.set", {{"time", nullptr}})["clock"]["time"], nullptr);
    EXPECT_EQ(wait(client)["quads"], whole["quads"]);
}

TEST_F(TimeMethods, GoesOnFromTheUpdateAnEarlierConnectionHad) {
    const std::uint32_t epoch = wait(client)["epoch"];
    protocol::MeshDecoder decoder;
    {
        WebSocketClient early(*server_, session);
        EXPECT_EQ(early.result("surface.subscribe", {{"surface", surface}})["resumed"], false);
        fold_until(early, decoder, is_final);
        early.socket().reset();
    }
    client.result("time.set", {{"time", 2.0}});
    const json stats = wait(client);
    WebSocketClient back(*server_, session);
    const json from{{"epoch", epoch}, {"seq", decoder.newest()->header.seq}};
    EXPECT_EQ(back.result("surface.subscribe", {{"surface", surface}, {"from", from}})["resumed"],
              true);
    const auto state = fold_until(back, decoder, is_final);
    EXPECT_EQ(state.header.state_sum, stats["stateSum"].get<std::uint32_t>());
    const json stranger{{"epoch", epoch + 7}, {"seq", 0}};
    EXPECT_EQ(
        back.result("surface.subscribe", {{"surface", surface}, {"from", stranger}})["resumed"],
        false);
    EXPECT_TRUE(fold_until(back, decoder, is_final).header.is_key()) << "a keyframe comes";
}

TEST_F(TimeMethods, HoldsUpdatesBackFromWhoDoesNotAcknowledgeThem) {
    wait(client);
    const std::uint32_t number =
        client.result("surface.subscribe", {{"surface", surface}})["subscription"];
    protocol::MeshDecoder decoder;
    fold_until(client, decoder, is_final);
    const auto acknowledge = [&] {
        client.send({{"jsonrpc", "2.0"},
                     {"method", "frame.ack"},
                     {"params",
                      {{"subscription", number},
                       {"epoch", decoder.newest()->header.epoch},
                       {"seq", decoder.newest()->header.seq}}}});
    };
    acknowledge();
    WebSocketClient prompt(*server_, session);
    prompt.result("surface.subscribe", {{"surface", surface}});
    protocol::MeshDecoder unbroken;
    client.result("time.play", {{"speed", 0.5}, {"loop", true}});
    EXPECT_EQ(client.notification("server.notice"),
              (json{{"kind", "catchingUp"}, {"surface", surface}, {"subscription", number}}));
    const std::uint32_t before = decoder.newest()->header.seq;
    fold_until(client, decoder, [&](const auto& header) { return header.seq >= before + 8; });
    // Only what the server makes meanwhile is held back.
    fold_until(prompt, unbroken, [&](const auto& header) { return header.seq >= before + 12; });
    acknowledge();
    const auto state =
        fold_until(client, decoder, [&](const auto& header) { return header.seq > before + 8; });
    EXPECT_TRUE(state.header.is_key()) << "what it missed comes as one keyframe";
    EXPECT_EQ(client.notification("server.notice")["kind"], "caughtUp");
    client.result("time.pause");
    EXPECT_GE(counted("wakesurf_catching_up_total"), 1);
    EXPECT_GE(counted("wakesurf_frames_dropped_total"), 1);
}

TEST(TimesOfData, AreThoseThatTheClockMayShowUnlessASurfaceIsOfAFormula) {
    const TemporaryFolder folder;
    store::GenerateRequest request;
    request.flow = "double-gyre";
    request.grid = {{0, 0, -1}, {0.25, 0.25, 0.5}, {9, 5, 5}};
    request.times = {2, 3, 4};
    ASSERT_TRUE(
        store::generate_store(request, folder / "gyre", [](const store::ImportProgress&) {}, {}));
    const ServerProcess server({folder / "gyre", "flow:oscillating"});
    WebSocketClient client(server);
    client.result("dataset.open", {{"dataset", "gyre"}});
    const auto error = [&](const std::string& method, const json& parameters) {
        return client.call(method, parameters).value("error", json::object());
    };
    client.result("time.set", {{"time", 900}}); // no surface is shown at it

    const json rake = client.result(
        "rake.set",
        {{"kind", "line"}, {"points", {{0.5, 0.5, 0}, {1.5, 0.5, 0}}}, {"seeds", 5}})["rake"];
    const auto surface = [&](const std::string& dataset, double from, double to) {
        client.result(
            "surface.set",
            {{"rake", rake}, {"kind", "stream"}, {"dataset", dataset}, {"from", from}, {"to", to}});
    };
    surface("gyre", 2, 3);
    json refused = error("time.set", {{"time", 900}});
    EXPECT_EQ(refused["code"], -32013) << refused;
    EXPECT_EQ(refused["data"]["kind"], "outsideTimeRange");
    EXPECT_EQ(refused["message"], "`time` 900 is outside the data's 2 to 4");
    EXPECT_EQ(refused["data"]["hint"], "choose a time from 2 to 4");
    EXPECT_EQ(error("time.play", {{"from", 1}, {"to", 4}})["message"],
              "`from` 1 is outside the data's 2 to 4");
    EXPECT_EQ(error("time.play", {{"from", 2}, {"to", 4.5}})["message"],
              "`to` 4.5 is outside the data's 2 to 4");
    for (const json& time : {json(2), json(4), json(4.0 + 1e-12), json(nullptr)})
        EXPECT_TRUE(error("time.set", {{"time", time}}).empty()) << time;

    surface("gyre", 2, 7); // followed for five in the field of time 2
    EXPECT_TRUE(error("time.set", {{"time", 7}}).empty());
    EXPECT_FALSE(error("time.set", {{"time", 7.5}}).empty());
    surface("oscillating", 0, 1);
    EXPECT_TRUE(error("time.set", {{"time", 900}}).empty());
}

TEST_F(TimeMethods, RefusesNumbersThatAreNoneAndSaysWhich) {
    const auto names = [&](const std::string& method, const json& parameters, const char* name) {
        const json error = refused(method, parameters);
        EXPECT_EQ(error.value("code", 0), -32602) << error.dump();
        EXPECT_NE(error.value("message", "").find(name), std::string::npos) << error.dump();
    };
    names("time.set", json::object(), "time");
    names("time.set", {{"time", "now"}}, "time");
    names("time.set", {{"time", 1e300}}, "time");
    names("time.play", {{"speed", 0}}, "speed");
    names("time.play", {{"speed", -1}}, "speed");
    names("time.play", {{"speed", 1e30}}, "speed");
    names("time.play", {{"from", 2}, {"to", 1}}, "to");
    names("time.play", {{"loop", 1}}, "loop");
    names("surface.subscribe", {{"surface", surface}, {"from", {{"epoch", 1}}}}, "seq");
    names("frame.ack", {{"subscription", 1}}, "seq");
    EXPECT_EQ(refused("frame.ack", {{"subscription", 999'999}, {"seq", 0}})["code"], -32004);
}

} // namespace wakesurf::tests::time_methods_test
