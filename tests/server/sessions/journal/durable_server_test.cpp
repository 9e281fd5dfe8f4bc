// The server with --state as its clients see it: restarts, a disk that refuses for a while, a second server.
#include "tests/support/programs.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <memory>

namespace wakesurf::tests::durable_server_test {

using nlohmann::json;

namespace {

json rake_at(double x) {
    return {{"kind", "line"}, {"points", {{x, -1, 0}, {x, 1, 0}}}, {"seeds", 8}};
}

json stream_on(const json& rake) {
    return {{"rake", rake}, {"kind", "stream"}, {"dataset", "lamb-oseen"}, {"from", 0}, {"to", 2}};
}

class DurableServer : public testing::Test {
  protected:
    std::vector<std::string> arguments() const {
        return {"flow:lamb-oseen", "--state", (folder / "state").string()};
    }

    TemporaryFolder folder;
};

/// While it lives, no file of the process grows: the disk is full for it alone.
class FullDisk {
  public:
    explicit FullDisk(pid_t process) : process_(process) {
        ::prlimit(process_, RLIMIT_FSIZE, nullptr, &before_);
        const rlimit none{0, before_.rlim_max};
        if (::prlimit(process_, RLIMIT_FSIZE, &none, nullptr) != 0)
            throw std::runtime_error("cannot limit the server's files");
    }

    ~FullDisk() { ::prlimit(process_, RLIMIT_FSIZE, &before_, nullptr); }

    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    pid_t process_;
    rlimit before_{};
};

} // namespace

TEST_F(DurableServer, BringsRecordsBackAndBuildsTheirSurfacesAgain) {
    json before;
    json surface;
    {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        const json rake = client.result("rake.set", rake_at(1));
        EXPECT_EQ(rake["durable"], true);
        surface = client.result("surface.set", stream_on(rake["rake"]));
        EXPECT_EQ(surface["durable"], true);
        client.result("rake.set", {{"rake", rake["rake"]},
                                   {"kind", "line"},
                                   {"points", {{2, -1, 0}, {2, 1, 0}}},
                                   {"seeds", 8},
                                   {"name", "moved"}});
        before = client.result("session.state", {{"session", "main"}});
        EXPECT_EQ(server.stop().status, 0);
    }
    ServerProcess server(arguments());
    WebSocketClient client(server);
    const json after = client.result("session.state", {{"session", "main"}});
    EXPECT_EQ(after["rakes"], before["rakes"]);
    ASSERT_EQ(after["surfaces"].size(), 1u);
    EXPECT_EQ(after["surfaces"][0]["rev"], before["surfaces"][0]["rev"]);
    const json stats =
        client.result("surface.wait", {{"surface", surface["surface"]}, {"timeoutMs", 20000}});
    EXPECT_EQ(stats["complete"], true);
    EXPECT_GT(stats["quads"], 0);
    // A client that still shows the surface as it was must not take the new one for an old state of it.
    EXPECT_GT(stats["epoch"], before["surfaces"][0]["epoch"]);
    const json next = client.result("rake.set", rake_at(3));
    EXPECT_NE(next["rake"], after["rakes"][0]["rake"]);
}

TEST_F(DurableServer, BringsSessionsBackByNameAndForgetsNone) {
    std::vector<std::string> ids;
    {
        ServerProcess server(arguments());
        WebSocketClient client(server, "");
        for (const char* name : {"Ada", "Grace"})
            ids.push_back(client.result("session.create", {{"name", name}})["session"]);
        json rake = rake_at(1);
        rake["session"] = ids[1];
        client.result("rake.set", rake);
        server.kill();
    }
    ServerProcess server(arguments());
    WebSocketClient client(server, "");
    EXPECT_EQ(client.result("session.state", {{"session", ids[0]}})["name"], "Ada");
    EXPECT_EQ(client.result("session.state", {{"session", ids[1]}})["rakes"].size(), 1u);
    const json fresh = client.result("session.create", {{"name", "Mary"}})["session"];
    EXPECT_NE(fresh, ids[0]);
    EXPECT_NE(fresh, ids[1]);
}

TEST_F(DurableServer, HasTheClockWhereItWas) {
    const auto clock = [](WebSocketClient& client) {
        return client.result("session.state")["clock"];
    };
    {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        client.result("time.set", {{"time", 1.25}});
        EXPECT_EQ(client.result("rake.set", rake_at(1))["durable"], true);
        server.kill();
    }
    json stopped;
    {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        EXPECT_EQ(clock(client)["time"], 1.25);
        client.result("time.play", {{"speed", 0.1}, {"from", 1}, {"to", 9}});
        stopped = clock(client);
        EXPECT_EQ(server.stop().status, 0);
    }
    ServerProcess server(arguments());
    WebSocketClient client(server);
    EXPECT_EQ(clock(client)["playing"], false);
    EXPECT_GE(clock(client)["time"], stopped["time"]);
    EXPECT_EQ(clock(client)["speed"], 0.1);
}

TEST_F(DurableServer, GivesEverybodyTheirPlaceAgain) {
    json ada, bob, link;
    const auto bearer = [](const json& made) {
        return Headers{{"Authorization", "Bearer " + made["key"].get<std::string>()}};
    };
    {
        ServerProcess server(arguments());
        WebSocketClient host(server, "");
        ada = host.result("session.join",
                          {{"session", "main"}, {"name", "Ada"}, {"colour", "#102030"}});
        link = host.result("session.share", {{"session", "main"}, {"role", "editor"}});
        WebSocketClient guest(server, "", bearer(link));
        bob = guest.result("session.join", {{"session", "main"}, {"name", "Bob"}});
        EXPECT_EQ(host.result("rake.set", rake_at(1))["durable"], true);
        server.kill();
    }
    ServerProcess server(arguments());
    const auto rejoin = [&](WebSocketClient& client, const json& before) {
        return client.result("session.join", {{"session", "main"},
                                              {"resumeToken", before["resumeToken"]},
                                              {"lastSeq", before["seq"]}});
    };
    WebSocketClient host(server, "");
    const json back = rejoin(host, ada);
    EXPECT_EQ(back["you"], ada["you"]);
    EXPECT_EQ(back["role"], "host");
    ASSERT_EQ(back["participants"].size(), 1u);
    EXPECT_EQ(back["participants"][0]["name"], "Ada");
    EXPECT_EQ(back["participants"][0]["colour"], "#102030");
    EXPECT_EQ(back["resumed"], false) << "of what was missed no one knows: a snapshot";
    EXPECT_NE(back["resumeToken"], ada["resumeToken"]) << "so that the page forgets what it saw";
    WebSocketClient guest(server, "", bearer(link));
    const json again = rejoin(guest, bob);
    EXPECT_EQ(again["you"], bob["you"]);
    EXPECT_EQ(again["role"], "editor");
    EXPECT_EQ(
        read_file(folder / "state" / "sessions.sqlite").find(ada["resumeToken"].get<std::string>()),
        std::string::npos);
}

TEST_F(DurableServer, TellsWhoComesWhileNothingCanBeWritten) {
    ServerProcess server(arguments());
    WebSocketClient early(server);
    std::unique_ptr<WebSocketClient> late;
    {
        const FullDisk full(server.pid());
        EXPECT_EQ(early.result("rake.set", rake_at(1))["durable"], false);
        late = std::make_unique<WebSocketClient>(server);
        const json notice = late->notification("server.notice");
        EXPECT_EQ(notice["kind"], "notDurable");
        EXPECT_EQ(notice, early.notification("server.notice")) << "as those who were there";
    }
    EXPECT_EQ(late->notification("server.notice")["kind"], "durableAgain");
}

TEST_F(DurableServer, LetsPeopleInByAShareLinkThatWasMadeBefore) {
    std::string key;
    {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        key = client.result("session.share", {{"role", "viewer"}})["key"];
        server.kill();
    }
    const ServerProcess server(arguments());
    const Headers link{{"Authorization", "Bearer " + key}};
    const auto call = [&](const char* text) {
        return json::parse(http(server.port(), "POST", "/rpc", link, text).body);
    };
    EXPECT_TRUE(
        call(R"({"jsonrpc":"2.0","id":1,"method":"session.state","params":{"session":"main"}})")
            .contains("result"));
    const json edit = call(
        R"({"jsonrpc":"2.0","id":1,"method":"rake.set","params":{"session":"main","kind":"line",
            "points":[[1,0,0],[2,0,0]],"seeds":4}})");
    EXPECT_EQ(edit["error"]["code"], -32003);
}

TEST_F(DurableServer, GoesOnWhereNothingCanBeWrittenAndCatchesUpWithoutARestart) {
    json rakes;
    {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        const json rake = client.result("rake.set", rake_at(1));
        EXPECT_EQ(rake["durable"], true);
        const json surface = client.result("surface.set", stream_on(rake["rake"]));
        {
            const FullDisk full(server.pid());
            for (int edit = 0; edit < 5; ++edit) {
                json moved = rake_at(2 + edit);
                moved["rake"] = rake["rake"];
                const json answer = client.result("rake.set", moved);
                EXPECT_EQ(answer["durable"], false);
                EXPECT_FALSE(answer["hint"].get<std::string>().empty());
                EXPECT_EQ(answer["hint"].get<std::string>().find(" /"), std::string::npos)
                    << "no path of the server";
            }
            EXPECT_EQ(client.notification("server.notice")["kind"], "notDurable");
            EXPECT_EQ(client.result("surface.wait", {{"surface", surface["surface"]},
                                                     {"timeoutMs", 20000}})["complete"],
                      true);
            EXPECT_EQ(http(server.port(), "GET", "/healthz").body, "ok");
        }
        EXPECT_EQ(client.notification("server.notice")["kind"], "durableAgain");
        EXPECT_EQ(client.result("rake.set", rake_at(9))["durable"], true);
        rakes = client.result("session.state")["rakes"];
        server.kill();
    }
    ServerProcess server(arguments());
    WebSocketClient client(server);
    EXPECT_EQ(client.result("session.state")["rakes"], rakes);
}

TEST_F(DurableServer, NoticesThatItsFolderIsDeletedAndWritesAllOfItAgain) {
    json rakes;
    for (const bool whole_folder : {true, false}) {
        ServerProcess server(arguments());
        WebSocketClient client(server);
        EXPECT_EQ(client.result("rake.set", rake_at(1))["durable"], true);
        if (whole_folder)
            std::filesystem::remove_all(folder / "state");
        else
            for (const char* name : {"sessions.sqlite", "sessions.sqlite-wal"})
                std::filesystem::remove(folder / "state" / name);
        const json lost = client.result("rake.set", rake_at(2));
        EXPECT_EQ(lost["durable"], false);
        EXPECT_NE(lost["hint"].get<std::string>().find("deleted"), std::string::npos) << lost;
        EXPECT_EQ(client.notification("server.notice")["kind"], "notDurable");
        EXPECT_EQ(client.notification("server.notice")["kind"], "durableAgain");
        EXPECT_EQ(client.result("rake.set", rake_at(3))["durable"], true);
        rakes = client.result("session.state")["rakes"];
        server.kill();
        ServerProcess again(arguments());
        WebSocketClient other(again);
        EXPECT_EQ(other.result("session.state")["rakes"], rakes);
    }
    EXPECT_EQ(rakes.size(), 6u);
}

TEST_F(DurableServer, LeavesAnotherFileInThePlaceOfItsOwnAlone) {
    ServerProcess server(arguments());
    WebSocketClient client(server);
    EXPECT_EQ(client.result("rake.set", rake_at(1))["durable"], true);
    std::filesystem::rename(folder / "state" / "sessions.sqlite", folder / "mine");
    write_file(folder / "state" / "sessions.sqlite", "someone's");
    EXPECT_EQ(client.result("rake.set", rake_at(2))["durable"], false);
    EXPECT_EQ(client.notification("server.notice")["kind"], "notDurable");
    EXPECT_EQ(client.result("rake.set", rake_at(3))["durable"], false);
    EXPECT_EQ(read_file(folder / "state" / "sessions.sqlite"), "someone's");
    std::filesystem::remove(folder / "state" / "sessions.sqlite");
    EXPECT_EQ(client.notification("server.notice")["kind"], "durableAgain");
    EXPECT_EQ(client.result("rake.set", rake_at(4))["durable"], true);
}

TEST_F(DurableServer, SaysNothingOfDurabilityWithoutAFolder) {
    ServerProcess server;
    WebSocketClient client(server);
    EXPECT_FALSE(client.result("rake.set", rake_at(1)).contains("durable"));
    client.send_frame(8, "\x03\xe8");
    const auto end = server.stop();
    EXPECT_NE(end.log.find("--state DIR"), std::string::npos) << end.log;
}

TEST_F(DurableServer, RefusesAFolderAnotherServerHasAndADamagedOne) {
    const auto start = [&](const std::filesystem::path& state) {
        std::FILE* pipe =
            ::popen((server_program() + " serve flow:abc --listen 127.0.0.1:0 --state " +
                     state.string() + " 2>&1 >/dev/null")
                        .c_str(),
                    "r");
        std::string text;
        std::array<char, 1024> part{};
        while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe) != nullptr)
            text += part.data();
        EXPECT_EQ(WEXITSTATUS(::pclose(pipe)), 1) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
        return text;
    };
    const ServerProcess server(arguments());
    EXPECT_NE(start(folder / "state").find("another server"), std::string::npos);
    std::filesystem::create_directory(folder / "damaged");
    const std::string bytes(8192, 'x');
    write_file(folder / "damaged" / "sessions.sqlite", bytes);
    EXPECT_NE(start(folder / "damaged").find("damaged"), std::string::npos);
    EXPECT_EQ(read_file(folder / "damaged" / "sessions.sqlite"), bytes);
}

} // namespace wakesurf::tests::durable_server_test
