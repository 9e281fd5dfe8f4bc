// The HTTP side over real sockets: static files, login, health, and clients that do not behave.
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace wakesurf::tests::http_test {

using nlohmann::json;

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

class Http : public ServerSuite {
  protected:
    static void SetUpTestSuite() {
        folder_.emplace();
        write(folder_->path() / "secret.txt", "secret");
        write(folder_->path() / "web" / "index.html", "<!doctype html>page");
        write(folder_->path() / "web" / "assets" / "decoder-0123abcd.wasm", "wasm");
        start({"flow:lamb-oseen", "--web", (folder_->path() / "web").string()});
    }

    static HttpReply get(std::string_view target, Headers headers = {}) {
        return http(server_->port(), "GET", target, std::move(headers));
    }
};

} // namespace

TEST_F(Http, GivesThePageAndItsFilesToAnybodyWithAStrictPolicy) {
    const HttpReply page = get("/");
    EXPECT_EQ(page.status, 200);
    EXPECT_EQ(page.body, "<!doctype html>page");
    EXPECT_EQ(page.header("content-type"), "text/html; charset=utf-8");
    EXPECT_EQ(page.header("x-content-type-options"), "nosniff");
    const std::string policy = page.header("content-security-policy");
    EXPECT_TRUE(holds(policy, "script-src 'self' 'wasm-unsafe-eval';"));
    EXPECT_TRUE(holds(policy, "frame-ancestors 'none'"));
    EXPECT_FALSE(holds(policy, "unsafe-inline"));
    const HttpReply wasm = get("/assets/decoder-0123abcd.wasm?v=1");
    EXPECT_EQ(wasm.header("content-type"), "application/wasm");
    EXPECT_TRUE(holds(wasm.header("cache-control"), "immutable"));
    EXPECT_EQ(get("/", {{"If-None-Match", page.header("etag")}}).status, 304);
    EXPECT_EQ(http(server_->port(), "HEAD", "/").header("content-length"), "19");
    EXPECT_EQ(get("/healthz").body, "ok");
}

TEST_F(Http, NeverLeavesTheFolderOfThePage) {
    for (const char* target :
         {"/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt",
          "/%252e%252e/secret.txt", "/..%2fsecret.txt", "//secret.txt",
          "/assets/..%5c..%5csecret.txt", "/./../secret.txt", "/assets/%00/../../secret.txt",
          "/etc/passwd", "/../../../../../../etc/passwd"}) {
        const HttpReply reply = get(target, server_->bearer());
        EXPECT_TRUE(reply.status == 404 || reply.status == 400) << target << " " << reply.status;
        EXPECT_FALSE(holds(reply.body, "secret\n")) << target;
        EXPECT_EQ(reply.body.find(folder_->path().string()), std::string::npos) << target;
    }
}

TEST_F(Http, WantsATokenForEverythingElse) {
    for (const char* target :
         {"/openrpc.json", "/rpc", "/ws", "/metrics", "/nothing",
          "/api/v1/datasets/lamb-oseen/obstacle.bin", "/api/v1/sessions/main/surfaces/s1/mesh.vtp"})
        EXPECT_EQ(get(target).status, 401) << target;
    EXPECT_EQ(get("/nothing", server_->bearer()).status, 404);
    EXPECT_EQ(get("/rpc", server_->bearer()).status, 405);
    EXPECT_EQ(http(server_->port(), "DELETE", "/healthz").status, 405);
    EXPECT_EQ(get("/ws", server_->bearer()).status, 426);
}

TEST_F(Http, SaysWhichPathIsMeantWhereTwoSlashesAreTogether) {
    for (const auto& [asked, meant] : {std::pair{"//rpc", "/rpc"},
                                       {"//ws", "/ws"},
                                       {"///openrpc.json", "/openrpc.json"},
                                       {"/api/v1//sessions/main", "/api/v1/sessions/main"}})
        for (const Headers& headers : {Headers{}, server_->bearer()}) {
            const HttpReply reply = get(asked, headers);
            EXPECT_EQ(reply.status, 404) << asked;
            EXPECT_NE(reply.body.find(std::string("ask for ") + meant + ":"), std::string::npos)
                << reply.body;
        }
    EXPECT_EQ(http(server_->port(), "POST", "//rpc").status, 404);
    EXPECT_EQ(get("/rpc").status, 401) << "what is there still wants its token";
}

TEST_F(Http, ExchangesTheTokenForALoginThatOpensEverything) {
    const auto login = [&](const std::string& body, Headers headers) {
        return http(server_->port(), "POST", "/api/v1/login", std::move(headers), body);
    };
    const Headers here{{"Origin", server_->origin()}};
    EXPECT_EQ(login(R"({"token":"wrong"})", here).status, 401);
    EXPECT_EQ(login(R"({"login":"wrong"})", here).status, 401);
    EXPECT_EQ(login(R"({"token":7})", here).status, 400);
    EXPECT_EQ(login("{}", here).status, 400);
    EXPECT_EQ(login("{", here).status, 400);
    EXPECT_EQ(
        login(json{{"token", server_->token()}}.dump(), {{"Origin", "http://evil.example"}}).status,
        403);
    const HttpReply reply = login(json{{"token", server_->token()}}.dump(), here);
    EXPECT_EQ(reply.status, 200);
    EXPECT_EQ(reply.header("cache-control"), "no-store");
    EXPECT_EQ(reply.header("set-cookie"), "") << "other ports would be sent it";
    const std::string mine = json::parse(reply.body)["login"];
    EXPECT_EQ(login(json{{"login", mine}}.dump(), here).status, 200);
    const Headers with{{"Authorization", "Bearer " + mine}};
    EXPECT_EQ(get("/openrpc.json", with).status, 200);
    Headers page = here;
    page.emplace_back("Sec-WebSocket-Protocol", "wakesurf.v1, wakesurf.login." + mine);
    RawSocket socket(server_->port());
    const HttpReply upgraded = handshake(socket, server_->port(), page);
    EXPECT_EQ(upgraded.status, 101);
    EXPECT_EQ(upgraded.header("sec-websocket-protocol"), "wakesurf.v1") << "and tells no secret";
    EXPECT_EQ(http(server_->port(), "POST", "/rpc", with,
                   R"({"jsonrpc":"2.0","id":1,"method":"server.ping"})")
                  .body,
              R"({"jsonrpc":"2.0","id":1,"result":{}})");
}

TEST_F(Http, LetsNothingInByWhatEveryPortOfTheHostIsSent) {
    const std::string mine =
        json::parse(http(server_->port(), "POST", "/api/v1/login", {{"Origin", server_->origin()}},
                         json{{"token", server_->token()}}.dump())
                        .body)["login"];
    const Headers stolen{
        {"Cookie", "wakesurf_session_" + std::to_string(server_->port()) + "=" + mine},
        {"Origin", server_->origin()}};
    for (const char* path :
         {"/openrpc.json", "/metrics", "/api/v1/sessions/main/session.json",
          "/api/v1/sessions/main/thumbnail", "/api/v1/datasets/lamb-oseen/obstacle.bin"})
        EXPECT_EQ(get(path, stolen).status, 401) << path;
    for (const char* path : {"/rpc", "/api/v1/sessions"})
        EXPECT_EQ(http(server_->port(), "POST", path, stolen, "{}").status, 401) << path;
    RawSocket socket(server_->port());
    EXPECT_EQ(handshake(socket, server_->port(), stolen).status, 401);
}

TEST_F(Http, ChecksEveryHandshakeBeforeTheUpgrade) {
    const std::string here = server_->origin();
    const std::string port = std::to_string(server_->port());
    const Headers bearer = server_->bearer();
    const auto with = [&](Headers headers) {
        headers.insert(headers.end(), bearer.begin(), bearer.end());
        return headers;
    };
    const std::vector<std::pair<Headers, int>> table{
        {{}, 401},
        {bearer, 101},
        {with({{"Origin", here}}), 101},
        {with({{"Origin", "http://localhost:" + port}}), 101},
        {with({{"Origin", "http://evil.example"}}), 403},
        {with({{"Origin", "null"}}), 403},
        {with({{"Origin", here + ".evil.example"}}), 403},
        {with({{"Origin", "http://127.0.0.1:1"}}), 403},
        {with({{"Origin", here}, {"Origin", here}}), 403},
        {with({{"Host", "evil.example"}}), 403},
        {with({{"Host", "evil.example"}, {"Origin", here}}), 403},
        {with({{"Host", "localhost:" + port}}), 101},
        {{{"Origin", here}}, 401},
        {{{"Origin", "http://evil.example"}}, 403},
        {{{"Authorization", "Bearer nonsense"}}, 401},
        {{{"Authorization", "Bearer "}}, 401},
        {{{"Cookie", "wakesurf_session_" + port + "=" + server_->token()}, {"Origin", here}}, 401},
    };
    for (const auto& [headers, expected] : table) {
        RawSocket socket(server_->port());
        EXPECT_EQ(handshake(socket, server_->port(), headers).status, expected)
            << testing::PrintToString(headers);
    }
    RawSocket query(server_->port());
    EXPECT_EQ(handshake(query, server_->port(), {}, "/ws?token=" + server_->token()).status, 401);
    RawSocket elsewhere(server_->port());
    EXPECT_EQ(handshake(elsewhere, server_->port(), bearer, "/elsewhere").status, 404);
}

TEST_F(Http, LimitsWrongTokensAndStillLetsTheRightOneIn) {
    int limited = 0;
    for (int i = 0; i < 100; ++i)
        limited += get("/openrpc.json", {{"Authorization", "Bearer wrong"}}).status == 429 ? 1 : 0;
    EXPECT_GT(limited, 50);
    EXPECT_EQ(get("/openrpc.json", server_->bearer()).status, 200);
}

TEST(HttpWrongTokens, CountOnceOnEachPath) {
    for (const std::string path : {"/rpc", "/api/v1/sessions"}) {
        const ServerProcess server({"flow:lamb-oseen"});
        int limited = 0;
        for (int i = 0; i < 100; ++i)
            limited += http(server.port(), "POST", path, {{"Authorization", "Bearer wrong"}}, "{}")
                                   .status == 429
                           ? 1
                           : 0;
        EXPECT_GT(limited, 0) << path;
        const std::string counted = http(server.port(), "GET", "/metrics", server.bearer()).body;
        const std::string line =
            R"(wakesurf_over_budget_total{kind="wrong_tokens"} )" + std::to_string(limited) + "\n";
        EXPECT_TRUE(holds(counted, line)) << path << ": " << line << counted;
    }
}

TEST_F(Http, TellsItsHealthUnderAnyNameButNotToOtherPages) {
    EXPECT_EQ(get("/healthz", {{"Host", "localhost"}}).body, "ok");
    EXPECT_EQ(get("/healthz", {{"Host", "10.0.0.7:8080"}}).body, "ok");
    EXPECT_EQ(get("/healthz", {{"Origin", "http://evil.example"}}).status, 403);
}

TEST_F(Http, ServesAPageThatCameThroughATunnelFromItsFilesToItsWebSocket) {
    const Headers page{{"Host", "localhost:9000"}, {"Origin", "http://localhost:9000"}};
    EXPECT_EQ(get("/assets/decoder-0123abcd.wasm", page).body, "wasm");
    const HttpReply reply = http(server_->port(), "POST", "/api/v1/login", page,
                                 json{{"token", server_->token()}}.dump());
    ASSERT_EQ(reply.status, 200);
    Headers in = page;
    in.emplace_back("Sec-WebSocket-Protocol",
                    "wakesurf.v1, wakesurf.login." +
                        json::parse(reply.body)["login"].get<std::string>());
    RawSocket socket(server_->port());
    EXPECT_EQ(handshake(socket, server_->port(), in).status, 101);
    in.back().second += "0";
    RawSocket forged(server_->port());
    EXPECT_NE(handshake(forged, server_->port(), in).status, 101);
}

TEST_F(Http, ServesItsFilesWhateverTheirOriginAndOnlyThose) {
    const Headers elsewhere{{"Origin", "http://lab:9000"}};
    EXPECT_EQ(get("/", elsewhere).status, 200);
    EXPECT_EQ(get("/assets/decoder-0123abcd.wasm", elsewhere).status, 200);
    EXPECT_EQ(get("/openrpc.json", elsewhere).status, 403);
    EXPECT_EQ(get("/assets/decoder-0123abcd.wasm", {{"Host", "rebound.example"}}).status, 403);
}

TEST(HttpFrames, AreForNamedOriginsOnly) {
    const ServerProcess server({"flow:abc", "--frame-origin", "https://wiki.example",
                                "--frame-origin", "http://localhost:8888"});
    const HttpReply reply = http(server.port(), "GET", "/healthz");
    EXPECT_TRUE(holds(reply.header("content-security-policy"),
                      "frame-ancestors https://wiki.example http://localhost:8888"));
    EXPECT_EQ(reply.header("x-frame-options"), "");
    const ServerProcess none({"flow:abc"});
    EXPECT_EQ(http(none.port(), "GET", "/healthz").header("x-frame-options"), "DENY");
}

TEST(HttpFlood, OfOneAddressWithoutATokenIsRefusedButNotItsHealthNorWhoHasTheToken) {
    ServerProcess server({"flow:lamb-oseen"});
    const std::string request = "GET /metrics HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n";
    constexpr int batch = 500;
    std::string requests;
    for (int i = 0; i < batch; ++i)
        requests += request;
    RawSocket flood(server.port());
    HttpReply refused;
    for (int batches = 0; refused.status != 429 && batches < 40; ++batches) {
        flood.send(requests);
        for (int i = 0; i < batch; ++i) {
            HttpReply reply = read_reply(flood);
            if (reply.status == 429)
                refused = std::move(reply);
            else
                EXPECT_EQ(reply.status, 401);
        }
    }
    EXPECT_EQ(refused.status, 429);
    EXPECT_EQ(refused.header("retry-after"), "1");
    EXPECT_EQ(http(server.port(), "GET", "/healthz").body, "ok");
    const HttpReply counted = http(server.port(), "GET", "/metrics", server.bearer());
    EXPECT_EQ(counted.status, 200);
    EXPECT_FALSE(holds(counted.body, R"(wakesurf_over_budget_total{kind="without_token"} 0)"));
}

TEST(Health, IsGoodAndSaysHowManyDatasetsCannotBeOpened) {
    const TemporaryFolder folder;
    write(folder.path() / "broken" / "store.json", "{");
    const ServerProcess server({"flow:lamb-oseen", folder / "broken"});
    WebSocketClient client(server);
    EXPECT_TRUE(client.call("dataset.open", {{"dataset", "broken"}}).contains("error"));
    const HttpReply reply = http(server.port(), "GET", "/healthz");
    EXPECT_EQ(reply.status, 200);
    EXPECT_EQ(reply.body, "ok, but of 2 datasets 1 has failed");
    const std::string counted = http(server.port(), "GET", "/metrics", server.bearer()).body;
    EXPECT_TRUE(holds(counted, R"(wakesurf_datasets{state="failed"} 1)"));
    EXPECT_TRUE(holds(counted, R"(wakesurf_datasets{state="ready"} 1)"));
}

TEST_F(Http, EndsClientsThatSendTheirHeaderForEver) {
    RawSocket silent(server_->port());
    RawSocket slow(server_->port());
    slow.send("GET / HTTP/1.1\r\nHost: local");
    RawSocket large(server_->port());
    large.send("GET / HTTP/1.1\r\nX: " + std::string(20000, 'x') + "\r\n\r\n");
    EXPECT_EQ(read_reply(large).status, 431);
    RawSocket garbage(server_->port());
    garbage.send("\x16\x03\x01\x02 this is TLS, say\r\n\r\n");
    EXPECT_EQ(read_reply(garbage).status, 400);
    EXPECT_TRUE(slow.closes());
    EXPECT_TRUE(silent.closes());
    EXPECT_EQ(get("/healthz").body, "ok");
}

TEST_F(Http, HandsOutAFinishedSurfaceAsAFile) {
    WebSocketClient client(*server_);
    const json rake = client.result(
        "rake.set", {{"kind", "line"}, {"points", {{0.5, 0, 0}, {2, 0, 0}}}, {"seeds", 8}});
    const json surface = client.result("surface.set", {{"rake", rake["rake"]},
                                                       {"kind", "stream"},
                                                       {"dataset", "lamb-oseen"},
                                                       {"from", 0},
                                                       {"to", 1}});
    const std::string path =
        "/api/v1/sessions/main/surfaces/" + surface["surface"].get<std::string>() + "/mesh.";
    const HttpReply file = get(path + "vtp", server_->bearer());
    ASSERT_EQ(file.status, 200);
    EXPECT_TRUE(holds(file.body, "<VTKFile"));
    Headers again = server_->bearer();
    again.emplace_back("If-None-Match", file.header("etag"));
    EXPECT_EQ(get(path + "vtp", again).status, 304);
    EXPECT_EQ(get("/api/v1/sessions/main/surfaces/s99/mesh.vtp", server_->bearer()).status, 404);
    EXPECT_EQ(get("/api/v1/datasets/lamb-oseen/obstacle.bin", server_->bearer()).status, 404);
}

TEST(ServerProcessTest, PrintsItsAddressAndEndsAtASignalSayingGoodbye) {
    ServerProcess server;
    EXPECT_EQ(server.first_line(), "wakesurf: " + server.origin() + "/#token=" + server.token());
    EXPECT_EQ(server.token().size(), 64u);
    WebSocketClient client(server);
    client.result("server.info");
    const std::string token = server.token();
    auto stopping = std::thread([&] { EXPECT_EQ(client.receive().close_code(), 1001u); });
    const auto end = server.stop();
    stopping.join();
    EXPECT_EQ(end.status, 0);
    EXPECT_FALSE(holds(end.log, token));
}

TEST(ServerProcessTest, TakesItsTokenFromAFileOnlyTheUserCanRead) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "token";
    std::string token;
    {
        const ServerProcess server({"flow:abc", "--token-file", file.string()});
        token = server.token();
    }
    EXPECT_EQ(std::filesystem::status(file).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    const ServerProcess again({"flow:abc", "--token-file", file.string()});
    EXPECT_EQ(again.token(), token);
}

TEST(ServerProcessTest, PutsTheLinkIntoAFileThatOnlyTheUserCanReadAndNowhereElse) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "link";
    write(file, "of an earlier server, readable for all");
    ServerProcess server({"flow:abc", "--url-file", file.string(), "--log-level", "debug"});
    EXPECT_EQ(server.first_line(), "wakesurf: " + server.origin() + "/");
    EXPECT_EQ(std::filesystem::status(file).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::string link;
    std::getline(std::ifstream(file), link);
    const std::string start = server.origin() + "/#token=";
    ASSERT_EQ(link.rfind(start, 0), 0u) << link;
    const std::string token = link.substr(start.size());
    const Headers bearer{{"Authorization", "Bearer " + token}};
    EXPECT_EQ(http(server.port(), "GET", "/openrpc.json", bearer).status, 200);
    const auto end = server.stop();
    EXPECT_FALSE(holds(end.log, token));
    EXPECT_EQ(end.log.find(file.string()), std::string::npos);
}

TEST(ServerProcessTest, ChangesTheTokenInTheFileWhereItIsAskedToAndLoginsAndLinksEnd) {
    const TemporaryFolder folder;
    const auto file = (folder.path() / "token").string();
    const auto state = (folder.path() / "state").string();
    std::string old;
    std::vector<std::string> secrets;
    const auto status = [&](const ServerProcess& server, const std::string& secret) {
        return http(server.port(), "GET", "/openrpc.json", {{"Authorization", "Bearer " + secret}})
            .status;
    };
    const auto log_in = [&](const ServerProcess& server, const std::string& secret) {
        const auto body = json{{"token", secret}}.dump();
        return json::parse(http(server.port(), "POST", "/api/v1/login", {}, body).body)["login"]
            .get<std::string>();
    };
    {
        const ServerProcess server({"flow:abc", "--token-file", file, "--state", state});
        old = server.token();
        const auto answer = json::parse(
            http(server.port(), "POST", "/rpc", server.bearer(),
                 R"({"jsonrpc":"2.0","id":1,"method":"session.share","params":{"session":"main",)"
                 R"("role":"host","expiresIn":null}})")
                .body);
        const std::string key = answer["result"]["key"];
        secrets = {old, key, log_in(server, old), log_in(server, key)};
    }
    {
        const ServerProcess same({"flow:abc", "--token-file", file, "--state", state});
        EXPECT_EQ(same.token(), old);
        for (const std::string& secret : secrets)
            EXPECT_EQ(status(same, secret), 200) << "they outlive the server";
    }
    {
        ServerProcess other({"flow:abc", "--token-file", file, "--state", state, "--new-token"});
        EXPECT_NE(other.token(), old);
        for (const std::string& secret : secrets)
            EXPECT_EQ(status(other, secret), 401);
        EXPECT_TRUE(holds(other.stop().log, "event=new_token links_ended=1"));
    }
    const ServerProcess later({"flow:abc", "--token-file", file, "--state", state});
    for (const std::string& secret : secrets)
        EXPECT_EQ(status(later, secret), 401) << "for good";
}

TEST(ServerProcessTest, WithoutAuthenticationStillMindsTheOrigin) {
    const ServerProcess server({"flow:abc", "--no-auth"});
    EXPECT_EQ(server.first_line(), "wakesurf: " + server.origin() + "/");
    EXPECT_EQ(http(server.port(), "GET", "/openrpc.json").status, 200);
    RawSocket own(server.port());
    EXPECT_EQ(handshake(own, server.port(), {}).status, 101);
    RawSocket other(server.port());
    EXPECT_EQ(handshake(other, server.port(), {{"Origin", "http://evil.example"}}).status, 403);
}

} // namespace wakesurf::tests::http_test
