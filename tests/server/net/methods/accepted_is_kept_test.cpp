// What an edit accepts is what a start accepts: every shape of record is sent while a dataset is ready, is being imported,
// has failed or is not there any more; the server is killed; all that was answered `durable: true` is there, the same.
#include "tests/support/server/record_shapes.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/slow_series.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::tests::accepted_is_kept_test {

using nlohmann::json;

namespace {

/// What a session is made of, without what ends with a life of the server.
json lasting(json state) {
    for (const char* gone : {"seq", "participants"})
        state.erase(gone);
    for (json& rake : state["rakes"]) {
        rake.erase("leasedBy");
        rake["dragging"] = false;
    }
    for (json& surface : state["surfaces"])
        surface.erase("epoch");
    state["clock"].erase("time"); // it ran on
    state["clock"]["playing"] = false;
    return state;
}

class AcceptedIsKept : public testing::Test {
  protected:
    json call(const std::string& method, const std::string& parameters) const {
        return json::parse(server->rpc(R"({"jsonrpc":"2.0","id":1,"method":")" + method +
                                       R"(","params":{"session":"main")" +
                                       (parameters.empty() ? "" : ",") + parameters + "}}"));
    }

    void send(const std::vector<RecordShape>& shapes) {
        for (const RecordShape& each : shapes) {
            const json answer = call(each.method, each.parameters);
            if (each.always_bad) {
                const int code = answer.value("error", json::object()).value("code", 0);
                EXPECT_TRUE(code == -32602 || code == -32700) << each.what << "\n"
                                                              << answer.dump().substr(0, 300);
            }
            if (!answer.contains("result"))
                continue;
            ++accepted;
            if (each.method != "time.set" && each.method != "time.play" &&
                each.method != "time.pause") {
                EXPECT_EQ(answer["result"]["durable"], true) << each.what;
            }
        }
    }

    /// Sends everything to a server with these datasets, kills it, and looks at what another one has.
    void run(std::vector<std::string> datasets, const std::vector<std::string>& later) {
        datasets.insert(datasets.end(), {"--store", folder / "cache", "--state", folder / "state"});
        server = std::make_unique<ServerProcess>(datasets);
        send(rake_shapes());
        const json list = call("rake.list", "")["result"]["rakes"];
        ASSERT_FALSE(list.empty());
        send(surface_shapes(list[0]["rake"]));
        send(other_shapes());
        // A rake in use, moved, and undone.
        send({{"an edit of a rake in use", "rake.set",
               R"("rake":")" + list[0]["rake"].get<std::string>() +
                   R"(","kind":"line","seeds":8,"points":[[0.5,0,0],[0.5,1,0]])"},
              {"the same without length", "rake.set",
               R"("rake":")" + list[0]["rake"].get<std::string>() +
                   R"(","kind":"line","seeds":8,"points":[[0.5,0,0],[0.5,0,0]])",
               true}});
        call("history.undo", "");
        const json forked = call("session.fork", R"("name":"fork")");
        send({{"what follows all of it", "annotation.set", R"("text":"last","position":[0,0,0])"}});
        const json before = call("session.state", "")["result"];
        server->kill();
        std::vector<std::string> arguments = later;
        arguments.insert(arguments.end(),
                         {"--store", folder / "cache", "--state", folder / "state"});
        server = std::make_unique<ServerProcess>(arguments);
        const json after = call("session.state", "")["result"];
        EXPECT_FALSE(after.contains("keptAside")) << after["keptAside"];
        EXPECT_EQ(lasting(after), lasting(before));
        if (forked.contains("result")) {
            json copy = lasting(json::parse(server->rpc(
                R"({"jsonrpc":"2.0","id":1,"method":"session.state","params":{"session":")" +
                forked["result"]["session"].get<std::string>() + "\"}}"))["result"]);
            EXPECT_EQ(copy["rakes"], lasting(before)["rakes"]);
        }
    }

    TemporaryFolder folder;
    std::unique_ptr<ServerProcess> server;
    int accepted = 0;
};

const std::vector<std::string> flow{"flow:lamb-oseen"};

} // namespace

TEST_F(AcceptedIsKept, WhereTheDatasetIsReady) {
    run(flow, flow);
    EXPECT_GT(accepted, 30);
}

TEST_F(AcceptedIsKept, WhereTheDatasetIsGoneAtTheNextStart) {
    run(flow, {"flow:abc"});
    EXPECT_GT(accepted, 30);
}

TEST_F(AcceptedIsKept, WhereTheDatasetHasNoTimeStepYet) {
    run({write_slow_series(folder.path())}, flow);
    EXPECT_GT(accepted, 20);
}

TEST_F(AcceptedIsKept, WhereTheDatasetHasFailed) {
    write_file(folder / "bad.vti", "nonsense");
    run({folder / "bad.vti"}, flow);
    EXPECT_GT(accepted, 20);
}

TEST_F(AcceptedIsKept, WhereItWasMadeWithTheDatasetAndIsEditedWithoutIt) {
    run(flow, flow);
    server.reset();
    run({"flow:abc"}, flow);
}

} // namespace wakesurf::tests::accepted_is_kept_test
