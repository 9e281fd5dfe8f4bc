// A server that died three times while it started, as people see the fourth.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::tests::careful_start_test {

using nlohmann::json;

namespace {

class CarefulStart : public testing::Test {
  protected:
    CarefulStart() {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        rake = client.result("rake.set", rake_at(1))["rake"];
        surface = client.result("surface.set", {{"rake", rake},
                                                {"kind", "stream"},
                                                {"dataset", "lamb-oseen"},
                                                {"from", 0},
                                                {"to", 2}})["surface"];
        before = client.result("surface.wait", {{"surface", surface}, {"timeoutMs", 60'000}});
        server.kill();
    }

    std::vector<std::string> arguments() const {
        return {"flow:lamb-oseen", "--state", (folder / "state").string()};
    }

    json rake_at(double x) const {
        json out{{"kind", "line"}, {"points", {{x, -1, 0}, {x, 1, 0}}}, {"seeds", 8}};
        if (!rake.empty())
            out["rake"] = rake;
        return out;
    }

    void die(int times) const {
        for (int i = 0; i < times; ++i)
            ServerProcess(arguments()).kill();
    }

    json wait(WebSocketClient& client) const {
        return client.call("surface.wait", {{"surface", surface}, {"timeoutMs", 60'000}});
    }

    TemporaryFolder folder;
    std::string rake, surface;
    json before;
};

} // namespace

TEST_F(CarefulStart, ComputesNothingOfBeforeAndTellsPeopleWhyAndWhatToDo) {
    die(2); // with the first one three
    ServerProcess server(arguments());
    WebSocketClient client(server);
    const json notice = client.notification("server.notice");
    EXPECT_EQ(notice["kind"], "carefulStart");
    EXPECT_EQ(notice["level"], "warning");
    EXPECT_NE(notice["text"].get<std::string>().find("3 times"), std::string::npos);
    EXPECT_EQ(client.result("rake.list")["rakes"].size(), 1U) << "no record is lost";

    client.result("surface.subscribe", {{"surface", surface}});
    const json error = wait(client)["error"];
    EXPECT_NE(
        error["data"]["hint"].get<std::string>().find("when it is edited or its rake is moved"),
        std::string::npos);
    client.result("rake.set", rake_at(1));
    EXPECT_EQ(wait(client)["result"]["stateSum"], before["stateSum"])
        << "the same, once someone asks for it";
    const auto end = server.stop();
    EXPECT_NE(end.log.find("event=careful_start died=3"), std::string::npos);
}

TEST_F(CarefulStart, DoesNotComeAfterTwoNorAfterACleanEnd) {
    die(1);
    {
        ServerProcess third(arguments());
        WebSocketClient client(third);
        EXPECT_EQ(wait(client)["result"]["stateSum"], before["stateSum"]);
        EXPECT_EQ(third.stop().status, 0);
    }
    die(2);
    ServerProcess server(arguments());
    WebSocketClient client(server);
    EXPECT_EQ(wait(client)["result"]["stateSum"], before["stateSum"]);
}

} // namespace wakesurf::tests::careful_start_test
