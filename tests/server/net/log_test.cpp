// What the server writes about itself: one line an event, `key=value`, and never a secret, a path or what somebody said.
#include "server/base/log_text.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace wakesurf::tests::log_test {

using nlohmann::json;
using server::log_value;

TEST(LogTest, KeepsEveryValueOnOneLineAndShort) {
    EXPECT_EQ(log_value("session-12"), "session-12");
    EXPECT_EQ(log_value(""), R"("")");
    EXPECT_EQ(log_value("two words"), R"("two words")");
    EXPECT_EQ(log_value("a\nevent=forged"), R"("a\x0aevent=forged")");
    EXPECT_EQ(log_value(R"(a "quote" \)"), R"("a \"quote\" \\")");
    EXPECT_EQ(log_value("\x1b[31m\xff"), R"("\x1b[31m\xff")");
    EXPECT_EQ(log_value(std::string(1000, 'x')).size(), 85u);
    for (int c = 0; c < 256; ++c) {
        const std::string value = log_value(std::string(3, static_cast<char>(c)));
        for (const char each : value)
            EXPECT_TRUE(each >= ' ' && each < 0x7f) << c;
    }
}

TEST(LogTest, OfAWholeExchangeAtItsMostTalkativeHasNoSecretAndNoPath) {
    const TemporaryFolder folder;
    std::vector<std::string> secrets{folder.path().string(), "no one-logs"};
    ServerProcess server({"flow:abc", "--log-level", "trace", "--store",
                          (folder.path() / "store").string(), "--token-file",
                          (folder.path() / "token").string()});
    secrets.push_back(server.token());
    const Headers here{{"Origin", server.origin()}};
    const std::string login = json::parse(
        http(server.port(), "POST", "/api/v1/login", here, json{{"token", server.token()}}.dump())
            .body)["login"];
    secrets.push_back(login.substr(login.rfind('.') + 1));
    ASSERT_EQ(secrets.back().size(), 64u);
    {
        RawSocket socket(server.port());
        Headers page = here;
        page.emplace_back("Sec-WebSocket-Protocol", "wakesurf.v1, wakesurf.login." + login);
        ASSERT_EQ(handshake(socket, server.port(), page).status, 101);
    }
    http(server.port(), "POST", "/api/v1/login", here, R"({"token":"wrong-nobody-logs"})");
    http(server.port(), "GET", "/no one-logs?token=no one-logs",
         {{"Authorization", "Bearer no one-logs"}});
    http(server.port(), "POST", "/rpc", server.bearer(), "no one-logs");
    {
        WebSocketClient client(server, "");
        client.call("session.join", {{"session", "main"}, {"name", "no one-logs\nevent=forged"}});
        const json joined =
            client.result("session.join", {{"session", "main"}, {"name", "no one-logs"}});
        secrets.push_back(joined["resumeToken"]);
        const json shared = client.call("session.share", {{"session", "main"}, {"role", "viewer"}});
        if (shared.contains("result"))
            secrets.push_back(shared["result"]["key"]);
        const json rake = client.result("rake.set", {{"kind", "line"},
                                                     {"points", {{0, 0, 0}, {1, 0, 0}}},
                                                     {"seeds", 8},
                                                     {"name", "no one-logs"}});
        const json surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                           {"kind", "stream"},
                                                           {"dataset", "abc"},
                                                           {"from", 0},
                                                           {"to", 1}});
        client.result("surface.subscribe", {{"surface", surface["surface"]}});
        client.result("surface.wait", {{"surface", surface["surface"]}, {"timeoutMs", 60000}});
        const json made = client.result("session.create", {{"name", "no one-logs"}});
        client.result("session.delete", {{"session", made["session"]}});
        client.result("session.restore", {{"session", made["session"]}});
        client.result("session.delete", {{"session", made["session"]}});
        client.result("session.delete", {{"session", made["session"]}, {"forever", true}});
        client.call("no one-logs\nevent=forged");
        client.call("dataset.describe", {{"dataset", "/etc/no one-logs"}});
        client.call("rake.list", {{"session", server.token()}});
        client.send_frame(2, "no one-logs");
    }
    const std::string log = server.stop().log;
    for (const std::string& secret : secrets)
        EXPECT_EQ(log.find(secret), std::string::npos) << secret << "\n" << log;
    const std::regex line(
        R"(time=\S+ level=[a-z]+ event=[a-z_]+( [a-z_]+=("([^"\\]|\\.)*"|[^ "]+))*)");
    std::istringstream lines(log);
    for (std::string each; std::getline(lines, each);)
        EXPECT_TRUE(std::regex_match(each, line)) << each;
    for (const char* event :
         {"event=listening", "event=client_opened", "event=refused", "event=client_closed",
          "event=call method=surface.set session=main", "event=session_created session=session-1",
          "event=session_deleted session=session-1", "event=session_restored session=session-1",
          "event=session_erased session=session-1", "event=stopping"})
        EXPECT_NE(log.find(event), std::string::npos) << event << "\n" << log;
}

} // namespace wakesurf::tests::log_test
