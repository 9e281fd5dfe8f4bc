// The whole path over a real socket: an edit of a rake, and the frames of the surface that follows from it.
#include "protocol/wire/mesh_decoder.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace wakesurf::tests::rake_edit_test {

using nlohmann::json;

namespace {

json rake_at(double z) {
    return {{"kind", "line"}, {"points", {{0.5, 0.0, z}, {2.0, 0.0, z}}}, {"seeds", 24}};
}

json surface_on(const std::string& rake, double separation = 0.1, double to = 4.0) {
    return {{"rake", rake}, {"kind", "stream"}, {"dataset", "lamb-oseen"},
            {"from", 0.0},  {"to", to},         {"separation", separation}};
}

struct Scene {
    std::string rake;
    std::string surface;
    std::uint32_t number = 0;
};

Scene make_scene(WebSocketClient& client, double separation = 0.1, double to = 4.0) {
    Scene scene;
    scene.rake = client.result("rake.set", rake_at(0.0))["rake"];
    scene.surface = client.result("surface.set", surface_on(scene.rake, separation, to))["surface"];
    scene.number = client.result("surface.subscribe", {{"surface", scene.surface}})["subscription"];
    return scene;
}

json wait_for(WebSocketClient& client, const Scene& scene) {
    return client.result("surface.wait", {{"surface", scene.surface}, {"timeoutMs", 60000}});
}

bool shows(const protocol::MeshDecoder& decoder, std::uint32_t epoch, protocol::Phase phase) {
    const auto& state = decoder.newest();
    return state && state->header.epoch == epoch && state->header.phase == phase;
}

/// Folds frames until the final state of `epoch` is there; returns the epochs seen.
std::set<std::uint32_t>
fold_until(WebSocketClient& client, protocol::MeshDecoder& decoder, std::uint32_t epoch) {
    std::set<std::uint32_t> epochs;
    while (!shows(decoder, epoch, protocol::Phase::Final)) {
        const auto frame = client.frame();
        const auto folded = decoder.fold(frame);
        EXPECT_TRUE(folded.has_value()) << folded.error().message;
        if (!folded)
            break;
        if (const auto header = protocol::read_frame(frame))
            epochs.insert(header->header.epoch);
    }
    return epochs;
}

} // namespace

TEST(RakeEdit, TheFramesFoldToTheMeshTheStatisticsDescribe) {
    const ServerProcess server;
    WebSocketClient client(server);
    const Scene scene = make_scene(client);
    protocol::MeshDecoder decoder;
    fold_until(client, decoder, 1);
    const json stats = wait_for(client, scene);
    EXPECT_EQ(stats["complete"], true);
    EXPECT_EQ(stats["epoch"], 1);
    EXPECT_GT(stats["quads"], 100);
    EXPECT_EQ(decoder.newest()->header.surface, scene.number);
    EXPECT_EQ(decoder.newest()->mesh->cells().size(), stats["quads"]);
    EXPECT_EQ(decoder.newest()->mesh->vertices(), stats["vertices"]);
    EXPECT_EQ(decoder.newest()->header.state_sum, stats["stateSum"]);
}

TEST(RakeEdit, OfFiftyEditsAtOnceOnlyTheNewestIsComputedToItsEnd) {
    const ServerProcess server;
    WebSocketClient client(server);
    const Scene scene = make_scene(client, 0.01, 8.0);
    int last = 0;
    for (int i = 1; i <= 50; ++i) {
        json edit = rake_at(-0.02 * i);
        edit["rake"] = scene.rake;
        last = client.next_id();
        client.send({{"jsonrpc", "2.0"}, {"id", last}, {"method", "rake.set"}, {"params", edit}});
    }
    const json answer = client.answer(last)["result"];
    EXPECT_EQ(answer["surfaces"][0]["epoch"], 51);
    protocol::MeshDecoder decoder;
    const auto epochs = fold_until(client, decoder, 51);
    EXPECT_LE(epochs.size(), 12u);
    const json stats = wait_for(client, scene);
    EXPECT_EQ(stats["epoch"], 51);
    EXPECT_EQ(decoder.newest()->header.state_sum, stats["stateSum"]);
    // The seeds lie where the last edit put them.
    const json state = client.result("session.state");
    EXPECT_DOUBLE_EQ(state["rakes"][0]["points"][0][2], -1.0);
}

TEST(RakeEdit, TwoPeopleSeeTheSameMesh) {
    const ServerProcess server;
    WebSocketClient one(server);
    WebSocketClient other(server);
    const Scene scene = make_scene(one);
    const json patched = other.notification("session.patched");
    EXPECT_EQ(patched["patches"][0]["record"]["rake"], scene.rake);
    other.result("surface.subscribe", {{"surface", scene.surface}});
    json edit = rake_at(1.0);
    edit["rake"] = scene.rake;
    other.result("rake.set", edit);
    protocol::MeshDecoder ones;
    protocol::MeshDecoder others;
    fold_until(one, ones, 2);
    fold_until(other, others, 2);
    const json stats = wait_for(one, scene);
    EXPECT_EQ(ones.newest()->header.state_sum, stats["stateSum"]);
    EXPECT_EQ(others.newest()->header.state_sum, stats["stateSum"]);
    EXPECT_EQ(one.result("session.state")["participants"].size(), 2u);
}

TEST(RakeEdit, WhoeverComesLateGetsTheMeshThatIsThere) {
    const ServerProcess server;
    WebSocketClient one(server);
    const Scene scene = make_scene(one);
    const json stats = wait_for(one, scene);
    WebSocketClient late(server);
    late.result("surface.subscribe", {{"surface", scene.surface}});
    protocol::MeshDecoder decoder;
    fold_until(late, decoder, 1);
    EXPECT_EQ(decoder.newest()->header.state_sum, stats["stateSum"]);
}

TEST(RakeEdit, AnEditStopsALongComputationAndShowsTheNewSurfaceSoon) {
    const ServerProcess server;
    WebSocketClient client(server);
    const Scene scene = make_scene(client, 0.004, 20.0); // minutes of work
    json edit = rake_at(2.0);
    edit["rake"] = scene.rake;
    client.result("rake.set", edit);
    protocol::MeshDecoder decoder;
    while (!decoder.newest() || decoder.newest()->header.epoch < 2) {
        ASSERT_TRUE(decoder.fold(client.frame()).has_value());
        ASSERT_FALSE(shows(decoder, 1, protocol::Phase::Final)) << "it went on to the end";
    }
    EXPECT_FALSE(shows(decoder, 2, protocol::Phase::Final));
}

TEST(RakeEdit, AClientThatVanishesInTheMiddleDisturbsNobody) {
    const ServerProcess server;
    WebSocketClient stays(server);
    const Scene scene = make_scene(stays, 0.02, 8.0);
    for (int i = 0; i < 8; ++i) {
        WebSocketClient vanishes(server);
        vanishes.result("surface.subscribe", {{"surface", scene.surface}});
        json edit = rake_at(0.1 * i);
        edit["rake"] = scene.rake;
        vanishes.result("rake.set", edit);
        vanishes.socket().reset();
    }
    protocol::MeshDecoder decoder;
    fold_until(stays, decoder, 9);
    EXPECT_EQ(decoder.newest()->header.state_sum, wait_for(stays, scene)["stateSum"]);
    EXPECT_TRUE(server.running());
}

TEST(RakeEdit, ARakeOutsideIsRefusedByHowMuchAndPartlyOutsideIsClipped) {
    const ServerProcess server;
    WebSocketClient client(server);
    json outside = rake_at(0.0);
    outside["points"] = {{20.0, 0.0, 0.0}, {20.0, 5.0, 0.0}};
    const json error = client.call("rake.set", outside)["error"];
    EXPECT_EQ(error["code"], -32012);
    EXPECT_NE(error["message"].get<std::string>().find("10"), std::string::npos) << error;
    json partly = rake_at(0.0);
    partly["points"] = {{0.0, 0.0, 0.0}, {20.0, 0.0, 0.0}};
    const json result = client.result("rake.set", partly);
    EXPECT_EQ(result["clipped"], true);
    EXPECT_DOUBLE_EQ(result["points"][1][0], 10.0);
}

TEST(RakeEdit, EverybodySeesThatARakeIsBeingDragged) {
    const ServerProcess server;
    WebSocketClient client(server);
    json edit = rake_at(0.0);
    edit["dragging"] = true;
    edit["rake"] = client.result("rake.set", rake_at(0.0))["rake"];
    client.result("rake.set", edit);
    EXPECT_EQ(client.result("rake.list")["rakes"][0]["dragging"], true);
    edit["dragging"] = false;
    client.result("rake.set", edit);
    EXPECT_EQ(client.result("rake.list")["rakes"][0]["dragging"], false);
}

TEST(RakeEdit, DeletingARakeTakesItsSurfacesAlong) {
    const ServerProcess server;
    WebSocketClient client(server);
    const Scene scene = make_scene(client, 0.004, 20.0);
    client.result("rake.delete", {{"rake", scene.rake}});
    EXPECT_EQ(client.result("surface.list")["surfaces"].size(), 0u);
    EXPECT_EQ(client.call("surface.stats", {{"surface", scene.surface}})["error"]["code"], -32004);
    EXPECT_EQ(client.result("server.ping"), json::object());
}

} // namespace wakesurf::tests::rake_edit_test
