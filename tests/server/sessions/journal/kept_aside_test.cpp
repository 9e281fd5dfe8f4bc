// Records that a start cannot use: they are kept, no one works with them unawares, and people are told.
#include "server/data/child_process.hpp"
#include "server/sessions/journal/state_store.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

namespace wakesurf::tests::kept_aside_test {

using nlohmann::json;

namespace {

/// Writes records as they would be after a zero-length rake was accepted.
void write_unsound_records(const std::string& file) {
    auto store = server::StateStore::open(file);
    ASSERT_TRUE(store) << store.error().message;
    const auto rake = [](const std::string& id, const char* end, const char* name) {
        return R"({"rake":")" + id + R"(","rev":1,"kind":"line","points":[[0,0,0],)" + end +
               R"(],"seeds":8,"name":")" + name +
               R"(","colour":"#102030","author":"Ada","clipped":false})";
    };
    server::PendingWrites changes;
    changes.write("main",
                  {{"session", "",
                    R"({"name":"main","seq":9,"nextRake":2,"nextSurface":1,"nextBookmark":1,)"
                    R"("nextAnnotation":1})"},
                   {"rake", "r1", rake("r1", "[1,0,0]", "good")},
                   {"rake", "r2", rake("r2", "[0,0,0]", "no length")},
                   {"participant", "p1", "not one"}});
    changes.write("session-7", {{"session", "", "{"}});
    ASSERT_TRUE(store->apply(changes));
}

std::string column(const std::string& path, const std::string& query) {
    sqlite3* database = nullptr;
    std::string out;
    sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
    sqlite3_exec(
        database, query.c_str(),
        [](void* to, int, char** values, char**) {
            *static_cast<std::string*>(to) += std::string(values[0]) + "\n";
            return 0;
        },
        &out, nullptr);
    sqlite3_close(database);
    return out;
}

/// What `wakesurf state aside` prints while the server runs.
json printed_aside(const std::string& folder) {
    std::string output;
    const auto outcome =
        server::run_child(server_program(), {"state", "aside", folder}, 0,
                          [&](std::string_view line) { output.append(line).push_back('\n'); }, {});
    EXPECT_TRUE(outcome && outcome->exit_status == 0);
    return json::parse(output, nullptr, false);
}

} // namespace

TEST(KeptAside, RecordsAreToldToPeopleAndOverwrittenByNothing) {
    const TemporaryFolder folder;
    const std::string path = folder / "sessions.sqlite";
    write_unsound_records(path);
    const std::vector<std::string> arguments{"flow:lamb-oseen", "--state", folder.path()};
    {
        ServerProcess server(arguments);
        WebSocketClient client(server, "");
        const json joined = client.result("session.join", {{"session", "main"}, {"name", "Ada"}});
        const json aside = joined["snapshot"]["keptAside"];
        EXPECT_EQ(aside["count"], 2);
        EXPECT_EQ(aside["records"][0]["type"], "rake");
        EXPECT_EQ(aside["records"][0]["id"], "r2");
        EXPECT_NE(aside["records"][0]["why"].get<std::string>().find("coincide"),
                  std::string::npos);
        EXPECT_GT(aside["records"][0]["since"], 1'700'000'000);
        const json notice = client.notification("server.notice");
        EXPECT_EQ(notice["kind"], "recordsKeptAside");
        EXPECT_EQ(notice["level"], "warning");
        EXPECT_NE(notice["text"].get<std::string>().find("r2"), std::string::npos) << notice;
        EXPECT_NE(notice["text"].get<std::string>().find("`wakesurf state aside"),
                  std::string::npos)
            << notice;
        EXPECT_EQ(joined["snapshot"]["rakes"].size(), 1u);
        const json other = client.result("session.state", {{"session", "session-7"}});
        EXPECT_EQ(other["keptAside"]["count"], 1) << "of a session without a name, too";
        const json made = client.result("rake.set", {{"session", "main"},
                                                     {"kind", "line"},
                                                     {"points", {{0, 0, 0}, {1, 1, 0}}},
                                                     {"seeds", 8}});
        EXPECT_EQ(made["rake"], "r3") << "no other record gets its id";
        EXPECT_EQ(made["durable"], true);
        EXPECT_EQ(server.stop().status, 0);
    }
    EXPECT_EQ(column(path, "SELECT id FROM aside WHERE session='main' ORDER BY id"), "p1\nr2\n");
    EXPECT_NE(column(path, "SELECT json FROM aside WHERE id='r2'").find("no length"),
              std::string::npos);
    ServerProcess server(arguments);
    WebSocketClient client(server);
    const json exported = printed_aside(folder.path());
    ASSERT_EQ(exported["records"].size(), 3u) << exported;
    for (const json& each : exported["records"]) {
        if (each["id"] == "p1") {
            EXPECT_EQ(each["record"], "not one") << "as text where it is no JSON";
        }
        if (each["id"] != "r2")
            continue;
        json rake = each["record"];
        EXPECT_EQ(rake["name"], "no length");
        EXPECT_EQ(each["session"], "main");
        EXPECT_NE(each["why"].get<std::string>().find("coincide"), std::string::npos);
        const json corrected{{"kind", rake["kind"]},
                             {"points", {{0, 0, 0}, {0, 1, 0}}},
                             {"seeds", rake["seeds"]},
                             {"name", rake["name"]}};
        EXPECT_EQ(client.result("rake.set", corrected)["rake"], "r4") << "its owner has it again";
    }
    EXPECT_EQ(client.result("session.state")["keptAside"]["count"], 2)
        << "as long as they are there";
    EXPECT_EQ(client.result("session.state")["rakes"].size(), 3u);
}

} // namespace wakesurf::tests::kept_aside_test
