// The whole path of a surface's fields over a real socket: an imported scalar, the frames that carry it, the files that hold it, a
// server that is started again.
#include "protocol/wire/mesh_decoder.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vti_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wakesurf::tests::fields_on_the_wire_test {

using nlohmann::json;

namespace {

/// 9 x 7 x 5 nodes a length of 1 apart, flowing along x; p = 2 x + 10 y - z, and a vector that a store has no room for.
std::string image() {
    VtiText out;
    out.nodes = {9, 7, 5};
    const auto x = [](std::size_t node) { return static_cast<double>(node % 9); };
    const auto y = [](std::size_t node) { return static_cast<double>(node / 9 % 7); };
    const auto z = [](std::size_t node) { return static_cast<double>(node / 63); };
    out.points =
        vti_array("U", 3, out.point_count(), [](std::size_t i) { return i % 3 == 0 ? 1.0 : 0.0; }) +
        vti_array("p", 1, out.point_count(),
                  [=](std::size_t i) { return 2.0 * x(i) + 10.0 * y(i) - z(i); }) +
        vti_array("heat flux", 3, out.point_count(), [](std::size_t) { return 0.25; });
    return out.text();
}

class FieldsOnTheWire : public testing::Test {
  protected:
    FieldsOnTheWire() { write_file(folder / "box.vti", image()); }

    std::vector<std::string> arguments() const {
        return {folder / "box.vti", "--store", folder / "store", "--state", folder / "state"};
    }

    static json surface_on(const std::string& rake, const json& fields) {
        return {{"rake", rake}, {"kind", "stream"},   {"dataset", "box"}, {"from", 0},
                {"to", 4},      {"separation", 0.25}, {"fields", fields}};
    }

    static void await_dataset(WebSocketClient& client) {
        while (client.result("dataset.list")["datasets"][0]["state"] != "ready")
            client.notification("dataset.patched");
    }

    static std::string make_rake(WebSocketClient& client) {
        await_dataset(client);
        return client.result(
            "rake.set",
            {{"kind", "line"}, {"points", {{1, 1.5, 2}, {1, 4.5, 2}}}, {"seeds", 9}})["rake"];
    }

    /// The final state of an epoch.
    static protocol::DecodedState
    final_state(WebSocketClient& client, protocol::MeshDecoder& decoder, std::uint32_t epoch) {
        for (;;) {
            const auto folded = decoder.fold(client.frame());
            if (!folded)
                throw std::runtime_error(folded.error().message);
            if (!*folded)
                continue;
            const auto& header = decoder.newest()->header;
            if (header.epoch == epoch && header.phase == protocol::Phase::Final)
                return *decoder.newest();
        }
    }

    static void expect_pressure(const protocol::DecodedState& state,
                                const json& lattice,
                                std::size_t attribute) {
        const auto& mesh = *state.mesh;
        const double step = lattice["step"];
        ASSERT_GT(mesh.vertices(), 50u);
        for (std::size_t v = 0; v < mesh.vertices(); ++v) {
            std::array<double, 3> x;
            for (std::size_t axis = 0; axis < 3; ++axis)
                x[axis] = lattice["origin"][axis].get<double>() + step * mesh.position[v][axis];
            ASSERT_NEAR(mesh.ranges[attribute].value(mesh.codes[attribute][v]),
                        2.0 * x[0] + 10.0 * x[1] - x[2], 3e-3);
        }
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(FieldsOnTheWire, FramesCarryWhatWasAskedForAlsoAfterARestart) {
    std::string surface;
    std::uint32_t epoch = 0;
    {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        const std::string rake = make_rake(client);
        surface = client.result("surface.set", surface_on(rake, json::array()))["surface"];
        const json plain = client.result("surface.subscribe", {{"surface", surface}});
        EXPECT_EQ(plain["attributes"], (json{"speed", "s", "t"}));
        protocol::MeshDecoder decoder;
        EXPECT_EQ(final_state(client, decoder, plain["epoch"]).header.attribute_count, 3);

        json edit = surface_on(rake, {"deformation", "p"});
        edit["surface"] = surface;
        epoch = client.result("surface.set", edit)["epoch"];
        EXPECT_GT(epoch, plain["epoch"].get<std::uint32_t>()) << "an edit of fields is an edit";
        const auto state = final_state(client, decoder, epoch);
        EXPECT_EQ(state.header.attribute_count, 5);
        expect_pressure(state, plain["lattice"], 4);
        const json again = client.result("surface.subscribe", {{"surface", surface}});
        EXPECT_EQ(again["attributes"], (json{"speed", "s", "t", "deformation", "p"}));
        EXPECT_EQ(server.stop().status, 0);
    }
    ServerProcess server(arguments());
    WebSocketClient client(server);
    await_dataset(client);
    while (client.call("surface.wait", {{"surface", surface}, {"timeoutMs", 20'000}})
               .contains("error"))
        client.notification("surface.done"); // it was begun before its dataset was there
    const json subscribed = client.result("surface.subscribe", {{"surface", surface}});
    protocol::MeshDecoder decoder;
    const auto state = final_state(client, decoder, subscribed["epoch"]);
    EXPECT_EQ(subscribed["attributes"], (json{"speed", "s", "t", "deformation", "p"}));
    EXPECT_EQ(state.header.attribute_count, 5);
    expect_pressure(state, subscribed["lattice"], 4);
}

TEST_F(FieldsOnTheWire, FilesHaveEachFieldOnce) {
    const ServerProcess server(arguments());
    WebSocketClient client(server);
    const std::string rake = make_rake(client);
    const std::string surface = client.result(
        "surface.set", surface_on(rake, {"deformation", "p", "U", "approximated"}))["surface"];
    client.result("surface.wait", {{"surface", surface}, {"timeoutMs", 20'000}});
    const std::string path = "/api/v1/sessions/main/surfaces/" + surface + "/mesh.ply";
    const std::string file = http(server.port(), "GET", path, server.bearer()).body;
    const std::string head = file.substr(0, file.find("end_header"));
    for (const char* name : {" speed\n", " deformation\n", " approximated\n", " p\n"}) {
        const auto first = head.find(name);
        ASSERT_NE(first, std::string::npos) << head;
        EXPECT_EQ(head.find(name, first + 1), std::string::npos) << head;
    }
}

TEST_F(FieldsOnTheWire, FramesHaveRoomForAFlowTextureItsColourAndTheColourOfSomeoneElse) {
    const ServerProcess server(arguments());
    WebSocketClient client(server);
    const std::string rake = make_rake(client);
    const json fields{"velocity_x", "velocity_y", "velocity_z", "deformation", "p"};
    const std::string surface = client.result("surface.set", surface_on(rake, fields))["surface"];
    const json subscribed = client.result("surface.subscribe", {{"surface", surface}});
    protocol::MeshDecoder decoder;
    const auto state = final_state(client, decoder, subscribed["epoch"]);
    EXPECT_EQ(state.header.attribute_count, 8);
    expect_pressure(state, subscribed["lattice"], 7);
}

TEST_F(FieldsOnTheWire, WhatCannotBeSentIsRefusedInWords) {
    const ServerProcess server(arguments());
    WebSocketClient client(server);
    const std::string rake = make_rake(client);
    const auto error = [&](const json& fields) {
        return client.call("surface.set", surface_on(rake, fields))["error"];
    };
    EXPECT_NE(error({"p", "U", "deformation", "approximated", "error", "speed"})["message"]
                  .get<std::string>()
                  .find("at most 5"),
              std::string::npos);
    const json vector = error({"heat flux"});
    EXPECT_NE(vector["message"].get<std::string>().find("a store holds one vector: heat flux"),
              std::string::npos)
        << vector;
    EXPECT_EQ(error({"q"})["data"]["hint"],
              "there is p, heat flux magnitude, U, deformation, approximated, error, vorticity, "
              "vorticity_x, vorticity_y, vorticity_z, q_criterion, velocity_x, velocity_y, "
              "velocity_z, normal_x, normal_y, normal_z, twin_distance, twin_lag");
    EXPECT_EQ(client.result("server.info")["limits"]["fields"], 5);
    EXPECT_EQ(client.result("dataset.describe", {{"dataset", "box"}})["surfaceFields"],
              (json{"p", "heat flux magnitude", "U", "deformation", "approximated", "error",
                    "vorticity", "vorticity_x", "vorticity_y", "vorticity_z", "q_criterion",
                    "velocity_x", "velocity_y", "velocity_z", "normal_x", "normal_y", "normal_z",
                    "twin_distance", "twin_lag"}));
}

TEST_F(FieldsOnTheWire, ProgressSaysWhatEachPassTook) {
    const ServerProcess server(arguments());
    WebSocketClient client(server);
    const std::string rake = make_rake(client);
    client.result("surface.set", surface_on(rake, {"p"}));
    for (json told; told["phase"] != "final";) {
        told = client.notification("surface.progress");
        ASSERT_EQ(told["seconds"].size(), 4u) << told;
        for (const char* stage : {"queue", "load", "compute", "encode"}) {
            EXPECT_GE(told["seconds"][stage], 0.0) << told;
            EXPECT_LT(told["seconds"][stage], 60.0) << told;
        }
        EXPECT_GT(told["seconds"]["compute"], 0.0);
    }
    const json stats = client.notification("surface.done")["stats"];
    EXPECT_EQ(stats["pass"].size(), 4u) << stats;
}

} // namespace wakesurf::tests::fields_on_the_wire_test
