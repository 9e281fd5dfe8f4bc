// cache.status, cache.patched and probe.sample against the real program with stored data.
#include "core/field/analytic_flow.hpp"
#include "store/store_generation.hpp"
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace wakesurf::tests::dataset_methods_test {

using nlohmann::json;

namespace {

class DatasetMethods : public ServerSuite {
  protected:
    static void SetUpTestSuite() {
        folder_.emplace();
        store::GenerateRequest request{.flow = "double-gyre",
                                       .grid = {{0, 0, -1}, {0.125, 0.125, 0.5}, {17, 9, 5}},
                                       .times = {0, 1, 2, 3, 4, 5}};
        const auto made = store::generate_store(request, *folder_ / "gyre",
                                                [](const store::ImportProgress&) {}, {});
        ASSERT_TRUE(made.has_value()) << made.error().message;
        start({*folder_ / "gyre", "flow:abc"});
        // A server answers before it has opened what it serves.
        ASSERT_EQ(call("dataset.open", {{"dataset", "gyre"}})["result"]["state"], "ready");
    }

    static json call(const std::string& method, const json& parameters) {
        const json request{
            {"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}};
        return json::parse(server_->rpc(request.dump()));
    }
};

} // namespace

TEST_F(DatasetMethods, ProbesGiveTheFieldBetweenNodesAndTimes) {
    const auto exact = core::make_analytic_flow("double-gyre").value();
    const json points{{0.5, 0.25, 0.0}, {1.25, 0.75, -0.5}, {2.5, 0.5, 0.0}};
    const auto answer =
        call("probe.sample", {{"dataset", "gyre"}, {"points", points}, {"time", 3.0}});
    ASSERT_TRUE(answer.contains("result")) << answer;
    EXPECT_EQ(answer["result"]["inside"], json({true, true, false}));
    const json name = call("dataset.describe", {{"dataset", "gyre"}})["result"]["velocity"];
    const auto& values = answer["result"]["values"][name.get<std::string>()];
    ASSERT_EQ(values.size(), 3u) << answer;
    EXPECT_TRUE(values[2].is_null()) << values; // outside there is no velocity
    for (std::size_t i = 0; i < 2; ++i) {       // at nodes and a stored time: exact but for float32
        const std::vector<core::Vec3> at{{points[i][0], points[i][1], points[i][2]}};
        const std::vector<double> time{3.0};
        std::vector<core::Vec3> velocity(1);
        ASSERT_TRUE(exact->sample(at, time, velocity, {}).has_value());
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(values[i][axis].get<double>(), velocity[0][axis], 1e-7) << i;
    }
}

TEST_F(DatasetMethods, SuggestsARakeAndSurfacesThatTheServerTakes) {
    for (const std::string dataset : {"gyre", "abc"}) {
        const json scene = call("dataset.suggest", {{"dataset", dataset}})["result"];
        ASSERT_EQ(scene["surfaces"].size(), 4u) << scene;
        EXPECT_NE(scene["why"].get<std::string>(), "");
        json rake = scene["rake"];
        rake["session"] = "main";
        const json made = call("rake.set", rake)["result"];
        EXPECT_EQ(made["clipped"], false) << made;
        for (json surface : scene["surfaces"]) {
            surface.update({{"session", "main"}, {"dataset", dataset}, {"rake", made["rake"]}});
            EXPECT_TRUE(call("surface.set", surface).contains("result")) << surface;
        }
        EXPECT_EQ(call("dataset.suggest", {{"dataset", dataset}})["result"], scene); // for everyone
    }
    EXPECT_EQ(call("dataset.suggest", {{"dataset", "none"}})["error"]["data"]["kind"], "notFound");
}

TEST_F(DatasetMethods, ProbesOfBuiltInFlowsAreExact) {
    const auto answer =
        call("probe.sample", {{"dataset", "abc"}, {"points", {{0, 0, 0}}}, {"time", 0.0}});
    const json values = answer["result"]["values"].begin().value();
    EXPECT_EQ(values, json::array({{0.0, 1.0, 1.0}})) << answer; // A=1 B=1 C=0
}

TEST_F(DatasetMethods, ProbesRefuseWhatTheyCannotAnswer) {
    const auto code = [](const json& more) {
        json parameters{{"dataset", "gyre"}, {"points", {{0.5, 0.5, 0.0}}}, {"time", 1.0}};
        parameters.update(more);
        return call("probe.sample", parameters)["error"]["code"].get<int>();
    };
    EXPECT_EQ(code({{"time", 7.0}}), -32013);
    EXPECT_EQ(code({{"dataset", "none"}}), -32004);
    EXPECT_EQ(code({{"fields", {"p"}}}), -32004);
    EXPECT_EQ(code({{"points", {{0.5, 0.5}}}}), -32602);
    EXPECT_EQ(code({{"points", 3}}), -32602);
}

TEST_F(DatasetMethods, TheCacheTellsWhichTimeStepsAreInMemory) {
    const auto before = call("cache.status", {{"dataset", "gyre"}})["result"];
    ASSERT_EQ(before["steps"].size(), 6u) << before;
    call("probe.sample", {{"dataset", "gyre"}, {"points", {{0.5, 0.5, 0.0}}}, {"time", 4.5}});
    const auto after = call("cache.status", {{"dataset", "gyre"}})["result"];
    EXPECT_EQ(after["steps"][4], "resident");
    EXPECT_EQ(after["steps"][5], "resident");
    EXPECT_GE(after["bytesPerStep"].get<std::uint64_t>(), 17u * 9 * 5 * 12);
    EXPECT_EQ(after["held"][4], json::array({after["bytesPerStep"], 0}));
    EXPECT_GE(after["bytes"].get<std::uint64_t>(), 2u * 17 * 9 * 5 * 12);
    EXPECT_LE(after["bytes"].get<std::uint64_t>(), after["budget"].get<std::uint64_t>());
    const auto none = call("cache.status", {{"dataset", "abc"}})["result"];
    EXPECT_EQ(none["steps"], json::array());
    EXPECT_EQ(none["held"], json::array());
}

TEST_F(DatasetMethods, ChangesOfTheCacheAreAnnounced) {
    ServerProcess server({*folder_ / "gyre"});
    WebSocketClient client(server);
    client.result("dataset.open", {{"dataset", "gyre"}});
    client.result("probe.sample",
                  {{"dataset", "gyre"}, {"points", {{0.5, 0.5, 0.0}}}, {"time", 0.5}});
    const auto whole =
        client.result("cache.status", {{"dataset", "gyre"}})["bytesPerStep"].get<std::uint64_t>();
    std::set<int> resident;
    while (resident.size() < 2) {
        const auto news = client.notification("cache.patched");
        EXPECT_EQ(news["dataset"], "gyre");
        for (const auto& change : news["changes"])
            if (change[1] == "resident")
                resident.insert(change[0].get<int>());
        for (const auto& change : news["held"])
            if (resident.contains(change[0].get<int>())) {
                EXPECT_EQ(change, json::array({change[0], whole, 0}));
            }
    }
    EXPECT_EQ(resident, (std::set{0, 1}));
}

} // namespace wakesurf::tests::dataset_methods_test
