// What careless and hostile clients send: each gets a clear error or a clean disconnect, and everybody else is served.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wakesurf::tests::bad_input_test {

using nlohmann::json;

namespace {

std::string request(const std::string& method, const std::string& parameters) {
    return R"({"jsonrpc":"2.0","id":1,"method":")" + method + R"(","params":)" + parameters + "}";
}

std::string rake(const std::string& points, const std::string& more = R"("seeds":8)") {
    return request("rake.set",
                   R"({"session":"main","kind":"line","points":)" + points + "," + more + "}");
}

constexpr const char* fine = "[[0,0,0],[1,0,0]]";

} // namespace

class BadInput : public testing::Test {
  protected:
    static void SetUpTestSuite() { server_ = new ServerProcess; }

    static void TearDownTestSuite() {
        delete server_;
        server_ = nullptr;
    }

    void TearDown() override {
        const auto answer = json::parse(server_->rpc(request("server.ping", "{}")));
        EXPECT_EQ(answer["result"], json::object()) << "the server does not serve any more";
    }

    static json error(const std::string& text) { return json::parse(server_->rpc(text))["error"]; }

    static ServerProcess* server_;
};

ServerProcess* BadInput::server_ = nullptr;

TEST_F(BadInput, IsRefusedWithTheFieldsName) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {rake("[[0,0,0],[1e300,0,0]]"), "`points`"},
        {rake("[[0,0,0],[1,0]]"), "`points`"},
        {rake("[[0,0,0],[1,0,\"0\"]]"), "`points`"},
        {rake("[[0,0,0],[1,0,null]]"), "`points`"},
        {rake("7"), "`points`"},
        {rake("{}"), "`points`"},
        {rake(fine, R"("seeds":1)"), "`seeds`"},
        {rake(fine, R"("seeds":1000000000)"), "`seeds`"},
        {rake(fine, R"("seeds":-4)"), "`seeds`"},
        {rake(fine, R"("seeds":3.5)"), "`seeds`"},
        {rake(fine, R"("seeds":1e300)"), "`seeds`"},
        {rake(fine, R"("seeds":"8")"), "`seeds`"},
        {rake(fine, R"("seeds":true)"), "`seeds`"},
        {rake(fine, R"("seeds":8,"colour":1)"), "`colour`"},
        {rake(fine, R"("seeds":8,"name":5)"), "`name`"},
        {rake(fine, R"("seeds":8,"name":"a\u0000b")"), "`name`"},
        {request("rake.set",
                 R"({"session":"main","kind":"spiral","points":[[0,0,0],[1,0,0]],"seeds":8})"),
         "`kind`"},
        {request("rake.set", R"({"session":"main","points":[[0,0,0],[1,0,0]],"seeds":8})"),
         "`kind`"},
        {request("rake.set", R"([[0,0,0],[1,0,0]])"), "`params`"},
        {request("surface.wait", R"({"session":"main","surface":"s1","timeoutMs":1e12})"),
         "`timeoutMs`"},
        {request("surface.wait", R"({"session":"main","surface":"s1"})"), "`timeoutMs`"},
        {request("dataset.describe", "{}"), "`dataset`"},
        {request("server.ping", R"({"extra":1})"), "`extra`"},
        {request("rake.list", "{}"), "`session`"},
    };
    for (const auto& [text, field] : cases) {
        const json fault = error(text);
        EXPECT_EQ(fault["code"], -32602) << text;
        EXPECT_NE(fault["message"].get<std::string>().find(field), std::string::npos)
            << text << "\n"
            << fault;
        EXPECT_TRUE(fault["data"]["kind"].is_string() && fault["data"]["hint"].is_string())
            << fault;
    }
}

TEST_F(BadInput, WithAMemberTwiceIsRefusedByName) {
    const json fault =
        error(R"({"jsonrpc":"2.0","id":1,"method":"server.ping","method":"session.create"})");
    EXPECT_EQ(fault["code"], -32600);
    EXPECT_EQ(fault["message"], "`method` appears twice");
}

TEST_F(BadInput, OfRakesThatAreNoneIsRefused) {
    EXPECT_EQ(error(rake("[[0,0,0],[0,0,0]]"))["code"], -32602);
    EXPECT_EQ(error(rake("[[0,0,0]]"))["code"], -32602);
    EXPECT_EQ(error(rake("[]"))["code"], -32602);
    EXPECT_EQ(error(rake("[[0,0,50],[1,0,50]]"))["code"], -32012);
    EXPECT_EQ(error(request("rake.delete", R"({"session":"main","rake":"r99"})"))["code"], -32004);
    EXPECT_EQ(error(request("rake.list", R"({"session":"../../etc"})"))["code"], -32004);
}

TEST_F(BadInput, OfSurfacesIsRefused) {
    const std::string id = json::parse(server_->rpc(rake(fine)))["result"]["rake"];
    const auto surface = [&](const std::string& more) {
        return error(
            request("surface.set", R"({"session":"main","rake":")" + id + "\"," + more + "}"));
    };
    EXPECT_EQ(surface(R"("kind":"stream","dataset":"nothing","from":0,"to":1)")["code"], -32004);
    EXPECT_EQ(surface(R"("kind":"stream","dataset":"lamb-oseen","from":1e300,"to":1)")["code"],
              -32602);
    EXPECT_EQ(
        surface(R"("kind":"stream","dataset":"lamb-oseen","from":2,"to":1,"direction":"forward")")
            ["code"],
        -32602);
    EXPECT_EQ(
        surface(
            R"("kind":"stream","dataset":"lamb-oseen","from":0,"to":1,"separation":-1)")["code"],
        -32602);
    for (const std::string separation : {"0", "1e-300", "1e-9", "1e300"}) {
        const json fault = surface(
            R"("kind":"stream","dataset":"lamb-oseen","from":0,"to":1,"separation":)" + separation);
        EXPECT_EQ(fault["code"], -32602) << separation;
        EXPECT_NE(fault["message"].get<std::string>().find("separation"), std::string::npos)
            << fault;
    }
    EXPECT_EQ(
        surface(R"("kind":"stream","dataset":"lamb-oseen","from":0,"to":1,"maxQuads":1000000000)")
            ["code"],
        -32602);
    EXPECT_EQ(
        surface(R"("kind":"stream","dataset":"lamb-oseen","from":0,"to":1,"fields":["p"])")["code"],
        -32602);
    const json sweep =
        surface(R"("kind":"path","dataset":"lamb-oseen","from":0,"to":1,"sweep":[0,1,0])");
    EXPECT_EQ(sweep["code"], -32602);
    EXPECT_NE(sweep["message"].get<std::string>().find("`sweep`"), std::string::npos);
    EXPECT_EQ(
        surface(R"("kind":"time","dataset":"lamb-oseen","from":0,"to":1,"rake2":"r99")")["code"],
        -32004);
    EXPECT_EQ(
        surface(
            R"("kind":"streak","dataset":"lamb-oseen","from":0,"to":1,"releaseUntil":2)")["code"],
        -32602);
}

TEST_F(BadInput, OfEnvelopesGetsTheSpecifiedCodes) {
    EXPECT_EQ(error("{nope")["code"], -32700);
    EXPECT_EQ(error(std::string(1000, '['))["code"], -32600);
    EXPECT_EQ(error("[]")["code"], -32600);
    EXPECT_EQ(error(request("no.such", "{}"))["code"], -32601);
    EXPECT_EQ(error(request("surface.subscribe", R"({"surface":"s1"})"))["code"], -32600);
    EXPECT_EQ(error(rake("[[0,0,0],[1e999,0,0]]"))["code"], -32700);
    EXPECT_EQ(error(rake("[[0,0,0],[NaN,0,0]]"))["code"], -32700);
}

TEST_F(BadInput, OfOneMegabyteClosesThatConnectionWithAnExplanation) {
    WebSocketClient other(*server_);
    WebSocketClient client(*server_);
    client.send_frame(1, std::string(1 << 20, 'x'));
    const auto message = client.closing();
    EXPECT_EQ(message.close_code(), 1009u);
    EXPECT_NE(message.payload.find("65536"), std::string::npos);
    EXPECT_EQ(other.result("server.ping"), json::object());
}

TEST_F(BadInput, OfOneMegabyteInSmallFragmentsClosesThatConnectionToo) {
    WebSocketClient client(*server_);
    for (int i = 0; i < 64; ++i)
        client.send_frame(i == 0 ? 1 : 0, std::string(16 << 10, 'x'), false);
    EXPECT_EQ(client.closing().close_code(), 1009u);
}

TEST_F(BadInput, OfOneMegabyteOverHttpIsAnswered413) {
    EXPECT_EQ(
        http(server_->port(), "POST", "/rpc", server_->bearer(), std::string(1 << 20, ' ')).status,
        413);
}

TEST_F(BadInput, OfBinaryMessagesClosesWith1003) {
    WebSocketClient client(*server_);
    client.send_frame(2, "draco");
    EXPECT_EQ(client.closing().close_code(), 1003u);
}

TEST_F(BadInput, OfBrokenFramesAndTextEndsThatConnectionOnly) {
    WebSocketClient client(*server_);
    client.socket().send("\x83\x80"
                         "garbage that is no frame at all");
    EXPECT_TRUE(client.socket().closes());
    WebSocketClient no_utf8(*server_);
    no_utf8.send_frame(1, "\xff\xfe\xfd");
    EXPECT_EQ(no_utf8.closing().close_code(), 1007u);
}

TEST_F(BadInput, OfDeepNestingIsRefusedOnTheSocketToo) {
    WebSocketClient client(*server_);
    client.send_frame(1, std::string(60000, '['));
    EXPECT_EQ(client.answer(nullptr)["error"]["code"], -32600);
    EXPECT_EQ(client.result("server.ping"), json::object());
}

} // namespace wakesurf::tests::bad_input_test
