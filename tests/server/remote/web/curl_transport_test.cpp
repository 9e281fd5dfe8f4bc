#include "server/remote/web/curl_transport.hpp"
#include "tests/support/server/scripted_web_server.hpp"
#include "tests/support/server/self_signed.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <mutex>

namespace wakesurf::server::curl_transport_test {

namespace {

using tests::ScriptedWebServer;
using Reply = ScriptedWebServer::Reply;

struct Got {
    tl::expected<HttpAnswer, HttpFault> answer;
    std::string body;
};

Got get(CurlTransport& transport, HttpRequest request, std::size_t room = 64) {
    std::string body(room, '\0');
    auto answer = transport.perform(request, std::as_writable_bytes(std::span(body)), {});
    body.resize(answer ? answer->bytes : 0);
    return {std::move(answer), std::move(body)};
}

Got get(const std::string& reply, bool cut = false, std::size_t room = 64) {
    const ScriptedWebServer server([&](const std::string&) { return Reply{reply, cut}; });
    CurlTransport transport{{}};
    return get(transport, {server.address("x")}, room);
}

} // namespace

TEST(CurlTransport, AsksForARangeOfTheObjectThatIsKnownAndReadsTheAnswer) {
    std::string asked;
    const ScriptedWebServer server([&](const std::string& header) {
        asked = header;
        return Reply{"HTTP/1.1 206 Partial Content\r\nETag: \"a1\"\r\ncontent-type: a/b\r\n"
                     "Content-Range: bytes 5-7/1000\r\nContent-Length: 3\r\n\r\nabc"};
    });
    CurlTransport transport{{}};
    const auto got = get(transport, {server.address("a/u.f32"), false, HttpRange{5, 3}, "\"a1\""});
    ASSERT_TRUE(got.answer) << got.answer.error().what;
    EXPECT_EQ(got.body, "abc");
    EXPECT_EQ(got.answer->status, 206);
    EXPECT_EQ(got.answer->etag, "\"a1\"");
    EXPECT_EQ(got.answer->content_type, "a/b");
    EXPECT_EQ(got.answer->range->first, 5u);
    EXPECT_EQ(got.answer->range->last, 7u);
    EXPECT_EQ(got.answer->range->total, 1000u);
    EXPECT_TRUE(asked.starts_with("GET /a/u.f32 HTTP/1.1\r\n")) << asked;
    EXPECT_NE(asked.find("\r\nRange: bytes=5-7\r\n"), std::string::npos) << asked;
    EXPECT_NE(asked.find("\r\nIf-Match: \"a1\"\r\n"), std::string::npos) << asked;
    EXPECT_EQ(asked.find("Authorization"), std::string::npos) << asked;
    EXPECT_EQ(asked.find("Accept-Encoding"), std::string::npos) << "packed bytes are others";
}

TEST(CurlTransport, KeepsItsConnections) {
    const ScriptedWebServer server([](const std::string& header) {
        return Reply{header.starts_with("HEAD")
                         ? "HTTP/1.1 200 OK\r\nContent-Length: 5000000000\r\n\r\n"
                         : "HTTP/1.1 503 Busy\r\nRetry-After: 7\r\nContent-Length: 2\r\n\r\nno"};
    });
    CurlTransport transport{{}};
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(get(transport, {server.address("x"), true}).answer->content_length, 5000000000u);
    const auto busy = get(transport, {server.address("x")});
    EXPECT_EQ(busy.answer->status, 503);
    EXPECT_EQ(busy.answer->retry_after, std::chrono::seconds(7));
    EXPECT_EQ(busy.body, "") << "no page about an error is taken for data";
    EXPECT_EQ(server.connections(), 1u);
}

TEST(CurlTransport, EndsWhereMoreComesThanThereIsRoomFor) {
    const auto got = get(
        "HTTP/1.1 200 OK\r\nContent-Length: 100000\r\n\r\n" + std::string(100000, 'x'), false, 10);
    ASSERT_TRUE(got.answer) << got.answer.error().what;
    EXPECT_EQ(got.body, std::string(10, 'x'));
    EXPECT_TRUE(got.answer->longer);
}

TEST(CurlTransport, ACutConnectionMayGoBetterTheNextTime) {
    for (const char* reply : {"", "HTTP/1.1 200 OK\r\nContent-Length: 10\r\n\r\nabc"}) {
        const auto got = get(reply, true);
        ASSERT_FALSE(got.answer);
        EXPECT_TRUE(got.answer.error().passing) << got.answer.error().what;
    }
}

TEST(CurlTransport, FollowsNoRedirects) {
    bool elsewhere = false;
    const ScriptedWebServer other([&](const std::string&) {
        elsewhere = true;
        return Reply{"HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n"};
    });
    const auto got =
        get("HTTP/1.1 302 Found\r\nContent-Length: 0\r\nLocation: " + other.address("secret") +
            "\r\n\r\n");
    ASSERT_TRUE(got.answer);
    EXPECT_EQ(got.answer->status, 302);
    EXPECT_EQ(got.answer->location, other.address("secret"));
    EXPECT_FALSE(elsewhere);
    CurlTransport transport{{}};
    const auto file = get(transport, {"file:///etc/passwd"});
    ASSERT_FALSE(file.answer);
    EXPECT_FALSE(file.answer.error().passing);
}

TEST(CurlTransport, SendsTheCredentialsThatTheEnvironmentHas) {
    std::string asked;
    const ScriptedWebServer server([&](const std::string& header) {
        asked = header;
        return Reply{"HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n"};
    });
    HttpCredentials token;
    token.token = "t0ken";
    CurlTransport bearer(token);
    EXPECT_TRUE(get(bearer, {server.address("x")}).answer);
    EXPECT_NE(asked.find("\r\nAuthorization: Bearer t0ken\r\n"), std::string::npos) << asked;
    HttpCredentials keys;
    keys.s3_region = "eu-central-1";
    keys.access_key = "AKIDEXAMPLE";
    keys.secret_key = "wJalrXUtnFEMI";
    keys.session_token = "session";
    CurlTransport aws(keys);
    EXPECT_TRUE(get(aws, {server.address("x"), false, HttpRange{0, 5}}).answer);
    EXPECT_NE(asked.find("Authorization: AWS4-HMAC-SHA256 Credential=AKIDEXAMPLE/"),
              std::string::npos)
        << asked;
    EXPECT_NE(asked.find("/eu-central-1/s3/aws4_request"), std::string::npos) << asked;
    EXPECT_NE(asked.find("X-Amz-Security-Token: session"), std::string::npos) << asked;
    EXPECT_EQ(asked.find("wJalrXUtnFEMI"), std::string::npos) << asked;
}

TEST(CurlTransport, TrustsNoCertificateThatNobodyVouchesFor) {
    const tests::TemporaryFolder folder;
    tests::write_self_signed(folder / "cert.pem", folder / "key.pem");
    const tests::ServerProcess server(
        {"flow:lamb-oseen", "--tls-cert", folder / "cert.pem", "--tls-key", folder / "key.pem"});
    const std::string address = "https://127.0.0.1:" + std::to_string(server.port()) + "/healthz";
    CurlTransport transport{{}};
    const auto got = get(transport, {address});
    ASSERT_FALSE(got.answer);
    EXPECT_FALSE(got.answer.error().passing) << got.answer.error().what;
    EXPECT_NE(got.answer.error().what.find("certificate"), std::string::npos)
        << got.answer.error().what;
}

TEST(CurlTransport, EndsWhereItIsStoppedWhileNothingComes) {
    std::stop_source stop;
    const ScriptedWebServer server([&](const std::string&) {
        stop.request_stop();
        Reply reply;
        reply.silent = true;
        return reply;
    });
    CurlTransport transport{{}};
    const auto got = transport.perform({server.address("x")}, {}, stop.get_token());
    ASSERT_FALSE(got);
    EXPECT_TRUE(got.error().cancelled);
}

} // namespace wakesurf::server::curl_transport_test
