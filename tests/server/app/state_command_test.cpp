// `wakesurf state`: the sessions a server keeps are checked, backed up and restored from outside, also while it runs.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <thread>

namespace wakesurf::tests::state_command_test {

using nlohmann::json;

namespace {

json rake_at(double x) {
    return {{"kind", "line"}, {"points", {{x, -1, 0}, {x, 1, 0}}}, {"seeds", 8}};
}

struct Said {
    int status = -1;
    std::string output;
    std::string errors;
};

class StateCommand : public testing::Test {
  protected:
    Said state(const std::vector<std::string>& words) const {
        Said said;
        std::vector<std::string> all{"state"};
        all.insert(all.end(), words.begin(), words.end());
        const auto outcome = server::run_child(
            server_program(), all, 0,
            [&](std::string_view line) { said.output.append(line).push_back('\n'); }, {});
        EXPECT_TRUE(outcome) << outcome.error().message;
        said.status = outcome->exit_status;
        said.errors = outcome->errors;
        return said;
    }

    static json rakes(const ServerProcess& server) {
        WebSocketClient client(server);
        return client.result("session.state", {{"session", "main"}})["rakes"];
    }

    TemporaryFolder folder;
    std::string kept = folder / "state";
    std::string file = folder / "backup.sqlite";
    std::vector<std::string> arguments{"flow:lamb-oseen", "--state", kept};
};

} // namespace

TEST_F(StateCommand, BacksUpAServerThatRunsWhileEditsGoOnAndPutsThatBack) {
    json before;
    {
        ServerProcess server(arguments);
        WebSocketClient client(server);
        for (int i = 0; i < 20; ++i)
            client.result("rake.set", rake_at(i * 0.1));
        std::atomic<bool> over = false;
        int edits = 0;
        std::thread editor([&] {
            WebSocketClient other(server, "");
            const json made = other.result("session.create", {{"name", "busy"}});
            json rake = rake_at(1);
            rake["session"] = made["session"];
            rake["rake"] = other.result("rake.set", rake)["rake"];
            for (; !over || edits < 5; ++edits)
                EXPECT_EQ(other.result("rake.set", rake)["durable"], true);
        });
        const Said checked = state({"check", kept});
        const Said backed_up = state({"backup", kept, file});
        over = true;
        editor.join();
        EXPECT_EQ(checked.status, 0) << checked.errors;
        EXPECT_EQ(checked.output.find("sound"), 0u) << checked.output;
        EXPECT_EQ(backed_up.status, 0) << backed_up.errors;
        EXPECT_GT(edits, 0);
        before = rakes(server);
        const Said again = state({"backup", kept, file});
        EXPECT_EQ(again.status, 1) << "a backup never overwrites one";
        const Said restored = state({"restore", kept, file});
        EXPECT_EQ(restored.status, 1);
        EXPECT_TRUE(holds(restored.errors, "stop it"));
        client.result("rake.set", rake_at(5));
        server.kill();
    }
    EXPECT_EQ(std::filesystem::status(file).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    const Said restored = state({"restore", kept, file});
    EXPECT_EQ(restored.status, 0) << restored.errors;
    EXPECT_TRUE(holds(restored.output, "sessions-replaced-"));
    EXPECT_FALSE(holds(restored.output, "new folder"));
    EXPECT_EQ(state({"check", kept}).status, 0);
    const std::string mistyped = folder / "sate";
    const Said elsewhere = state({"restore", mistyped, file});
    EXPECT_EQ(elsewhere.status, 0) << elsewhere.errors;
    EXPECT_TRUE(holds(elsewhere.output, "new folder, which was not there: " + mistyped));
    const ServerProcess server(arguments);
    EXPECT_EQ(rakes(server), before);
}

TEST_F(StateCommand, SaysWhatIsDamagedAndRestoresWhatCanBeRead) {
    {
        ServerProcess server(arguments);
        WebSocketClient client(server);
        for (int i = 0; i < 200; ++i) {
            json rake = rake_at(i * 0.01);
            rake["name"] = "rake with a name that takes some room " + std::to_string(i);
            client.result("rake.set", rake);
        }
        EXPECT_EQ(server.stop().status, 0);
    }
    const std::string path = kept + "/sessions.sqlite";
    std::string bytes = read_file(path);
    const std::size_t page = bytes.find("takes some room 100") / 4096 * 4096;
    write_file(path, bytes.replace(page, 4096, 4096, '\0'));
    const Said checked = state({"check", kept});
    EXPECT_EQ(checked.status, 1);
    EXPECT_EQ(checked.output.find("damaged"), 0u) << checked.output;
    EXPECT_TRUE(holds(checked.errors, "restore"));
    EXPECT_EQ(read_file(path), bytes) << "checking changes nothing";
    EXPECT_EQ(state({"backup", kept, file}).status, 1) << "this would be no backup";
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_EQ(state({"restore", kept, path}).status, 1);
    const Said restored = state({"restore", kept, path, "--damaged"});
    EXPECT_EQ(restored.status, 0) << restored.errors;
    EXPECT_TRUE(holds(restored.output, "not restored"));
    const ServerProcess server(arguments);
    const std::size_t there = rakes(server).size();
    EXPECT_GT(there, 150u) << "only what was on the page is gone";
    EXPECT_LT(there, 200u);
}

TEST_F(StateCommand, SaysWhatIsWrongWithItsArguments) {
    EXPECT_EQ(state({}).status, 2);
    EXPECT_EQ(state({"check"}).status, 2);
    EXPECT_EQ(state({"backup", kept}).status, 2);
    const Said missing = state({"check", kept});
    EXPECT_EQ(missing.status, 1);
    EXPECT_TRUE(holds(missing.errors, "no state folder"));
    EXPECT_FALSE(std::filesystem::exists(kept)) << "looking makes nothing";
    EXPECT_EQ(state({"restore", kept, folder / "nothing"}).status, 1);
}

} // namespace wakesurf::tests::state_command_test
