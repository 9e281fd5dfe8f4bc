// HTTP and WebSockets over TLS: the same service, logins, and no one who does not speak TLS 1.2.
#include "tests/support/server/self_signed.hpp"
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/tls_socket.hpp"

#include <gtest/gtest.h>
#include <openssl/ssl.h>

#include <chrono>
#include <filesystem>
#include <string>

namespace wakesurf::tests::tls_test {

namespace {

class Tls : public ServerSuite {
  protected:
    static void SetUpTestSuite() {
        folder_.emplace();
        write_self_signed(certificate(), folder_->path() / "key.pem");
        start({"flow:abc", "--tls-cert", certificate().string(), "--tls-key",
               (folder_->path() / "key.pem").string(), "--origin", "https://viewer.example"});
    }

    static std::filesystem::path certificate() { return folder_->path() / "certificate.pem"; }

    static std::string origin() { return "https://127.0.0.1:" + std::to_string(server_->port()); }

    static std::string ask(std::string_view method,
                           std::string_view target,
                           const Headers& headers = {},
                           std::string_view body = {}) {
        return https(server_->port(), certificate(), method, target, headers, body);
    }

    static int status(const std::string& response) { return std::stoi(response.substr(9, 3)); }
};

std::string header_of(const std::string& response, const std::string& name) {
    const auto at = response.find("\r\n" + name + ": ");
    if (at == std::string::npos)
        return {};
    const auto begin = at + name.size() + 4;
    return response.substr(begin, response.find("\r\n", begin) - begin);
}

} // namespace

TEST_F(Tls, PrintsAnHttpsAddressAndServesIt) {
    EXPECT_EQ(server_->first_line(), "wakesurf: " + origin() + "/#token=" + server_->token());
    EXPECT_EQ(status(ask("GET", "/healthz")), 200);
    EXPECT_EQ(status(ask("GET", "/openrpc.json")), 401);
    const std::string answer = ask("POST", "/rpc", server_->bearer(),
                                   R"({"jsonrpc":"2.0","id":1,"method":"server.ping"})");
    EXPECT_NE(answer.find(R"({"jsonrpc":"2.0","id":1,"result":{}})"), std::string::npos) << answer;
}

TEST_F(Tls, MakesALoginThatOpensAWebSocket) {
    const std::string reply = ask("POST", "/api/v1/login", {{"Origin", origin()}},
                                  R"({"token":")" + server_->token() + "\"}");
    EXPECT_EQ(status(reply), 200);
    const std::string begin = R"("login":")";
    const std::string login = reply.substr(reply.find(begin) + begin.size());
    const std::string upgrade =
        "GET /ws HTTP/1.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: "
        "13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nHost: 127.0.0.1:" +
        std::to_string(server_->port()) +
        "\r\nSec-WebSocket-Protocol: wakesurf.v1, wakesurf.login." +
        login.substr(0, login.find('"')) + "\r\nOrigin: ";
    TlsSocket socket(server_->port(), certificate());
    socket.send(upgrade + origin() + "\r\n\r\n");
    EXPECT_EQ(status(socket.receive_until("\r\n\r\n")), 101);
    const std::string call = R"({"jsonrpc":"2.0","id":7,"method":"server.ping"})";
    socket.send("\x81" + std::string(1, static_cast<char>(0x80 + call.size())) +
                std::string(4, '\0') + call);
    EXPECT_NE(socket.receive().find(R"("id":7,"result":{})"), std::string::npos);
    // A close frame: answered, and the connection ends with both layers' goodbyes.
    socket.send(std::string("\x88\x82\0\0\0\0\x03\xe8", 8));
    EXPECT_EQ(socket.receive_until("").substr(0, 2), "\x88\x02");
    EXPECT_TRUE(socket.ended_in_order());
    TlsSocket plain(server_->port(), certificate());
    plain.send(upgrade + "http://127.0.0.1:" + std::to_string(server_->port()) + "\r\n\r\n");
    EXPECT_EQ(status(plain.receive_until("\r\n\r\n")), 403);
}

TEST_F(Tls, SpeaksVersion12AndLaterOnly) {
    EXPECT_EQ(TlsSocket(server_->port(), certificate()).version(), "TLSv1.3");
    EXPECT_EQ(TlsSocket(server_->port(), certificate(), TLS1_2_VERSION).version(), "TLSv1.2");
    EXPECT_FALSE(TlsSocket(server_->port(), certificate(), TLS1_1_VERSION).connected());
    EXPECT_FALSE(TlsSocket(server_->port(), certificate(), TLS1_VERSION).connected());
    EXPECT_EQ(status(ask("GET", "/healthz")), 200);
}

TEST_F(Tls, SpeaksEphemeralKeysAndAuthenticatedCiphersOnly) {
    const auto connects = [](const char* cipher) {
        return TlsSocket(server_->port(), certificate(), TLS1_2_VERSION, cipher).connected();
    };
    for (const char* good : {"ECDHE+AESGCM", "ECDHE+CHACHA20"})
        EXPECT_TRUE(connects(good)) << good;
    for (const char* weak : {"AES256-SHA", "AES128-SHA", "AES128-SHA256", "AES256-GCM-SHA384",
                             "ECDHE-RSA-AES128-SHA256:ECDHE-ECDSA-AES128-SHA256",
                             "ECDHE-RSA-AES256-SHA:ECDHE-ECDSA-AES256-SHA"})
        EXPECT_FALSE(connects(weak)) << weak;
}

TEST(TlsRenewal, TakesARenewedCertificateAtAHangUpAndKeepsWhatIsOpen) {
    const TemporaryFolder folder;
    const auto certificate = folder.path() / "certificate.pem";
    const auto key = folder.path() / "key.pem";
    const auto first = folder.path() / "first.pem";
    write_self_signed(certificate, key);
    std::filesystem::copy_file(certificate, first);
    ServerProcess server(
        {"flow:abc", "--tls-cert", certificate.string(), "--tls-key", key.string()});
    TlsSocket open(server.port(), first);
    ASSERT_TRUE(open.connected());
    write_self_signed(certificate, key);
    const auto answers = [&](const std::filesystem::path& trusted) {
        return TlsSocket(server.port(), trusted).connected();
    };
    EXPECT_TRUE(answers(first)) << "not before it is told to";
    const auto hang_up = [&](const std::filesystem::path& expected) {
        ::kill(server.pid(), SIGHUP);
        bool there = false;
        for (int tries = 0; tries < 2000 && !there; ++tries)
            there = answers(expected);
        return there;
    };
    EXPECT_TRUE(hang_up(certificate));
    EXPECT_FALSE(answers(first));
    open.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    EXPECT_NE(open.receive_until("").find("200 OK"), std::string::npos) << "what is open goes on";
    std::filesystem::copy_file(certificate, first,
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(key, 10);
    EXPECT_TRUE(hang_up(first)) << "a key that is none changes nothing";
    const auto log = server.stop().log;
    EXPECT_NE(log.find("event=certificate_renewed"), std::string::npos) << log;
    EXPECT_NE(log.find("event=certificate_kept"), std::string::npos) << log;
}

TEST_F(Tls, TellsBrowsersToStayWithItOnlyUnderANameOfItsOwn) {
    EXPECT_EQ(header_of(ask("GET", "/healthz"), "Strict-Transport-Security"), "");
    EXPECT_EQ(
        header_of(ask("GET", "/healthz", {{"Host", "localhost"}}), "Strict-Transport-Security"),
        "");
    EXPECT_EQ(header_of(ask("GET", "/healthz", {{"Host", "viewer.example"}}),
                        "Strict-Transport-Security"),
              "max-age=86400");
}

TEST_F(Tls, TellsSomebodyWhoSpeaksPlainHttpWhatToDo) {
    RawSocket socket(server_->port());
    socket.send("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
    const HttpReply reply = read_reply(socket);
    EXPECT_EQ(reply.status, 400);
    EXPECT_NE(reply.body.find("https://"), std::string::npos);
    EXPECT_NE(reply.header("content-security-policy"), "");
    EXPECT_TRUE(socket.closes());
    const ServerProcess plain({"flow:abc"});
    EXPECT_FALSE(TlsSocket(plain.port(), certificate()).connected());
}

TEST_F(Tls, EndsHandshakesThatDoNotFinishAndServesTheOthersMeanwhile) {
    const auto start = std::chrono::steady_clock::now();
    RawSocket silent(server_->port());
    RawSocket begun(server_->port());
    begun.send(std::string("\x16\x03\x01\x02\0\x01", 6));
    RawSocket garbage(server_->port());
    garbage.send("\x16this is no handshake at all");
    EXPECT_TRUE(garbage.closes());
    EXPECT_EQ(status(ask("GET", "/healthz")), 200);
    EXPECT_TRUE(begun.closes());
    EXPECT_TRUE(silent.closes());
    EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::seconds(9));
    EXPECT_EQ(status(ask("GET", "/healthz")), 200);
}

} // namespace wakesurf::tests::tls_test
