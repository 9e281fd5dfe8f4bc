#include "protocol/api/json_rpc.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace wakesurf::protocol::json_rpc_test {

using nlohmann::json;

namespace {

const RpcLimits limits{};

/// The code a single message is refused with, or 0.
int refusal(const std::string& text) {
    const RpcMessage message = parse_rpc(text, limits);
    EXPECT_FALSE(message.batch);
    EXPECT_EQ(message.calls.size(), 1u);
    const auto& refused = message.calls.front().refused;
    return refused ? static_cast<int>(refused->code) : 0;
}

std::string call(const std::string& members) {
    return R"({"jsonrpc":"2.0",)" + members + "}";
}

} // namespace

TEST(JsonRpc, ReadsACall) {
    const RpcMessage message =
        parse_rpc(call(R"("id":7,"method":"rake.set","params":{"seeds":3})"), limits);
    ASSERT_EQ(message.calls.size(), 1u);
    const RpcCall& only = message.calls.front();
    EXPECT_FALSE(only.refused);
    EXPECT_EQ(only.method, "rake.set");
    EXPECT_EQ(*only.id, "7");
    EXPECT_EQ((*only.parameters)["seeds"], 3);
}

TEST(JsonRpc, EchoesIdsAsTheyCame) {
    for (const char* id : {"1", "-5", "\"a\\\"b\"", "null", "1.5", "\"\"", "18446744073709551615"})
        EXPECT_EQ(*parse_rpc(call(std::string(R"("id":)") + id + R"(,"method":"m")"), limits)
                       .calls.front()
                       .id,
                  id);
    EXPECT_FALSE(parse_rpc(call(R"("method":"m")"), limits).calls.front().id) << "a notification";
}

TEST(JsonRpc, RefusesWhatIsNoRequest) {
    EXPECT_EQ(refusal("{"), -32700);
    EXPECT_EQ(refusal(""), -32700);
    EXPECT_EQ(refusal("\xff"), -32700);
    EXPECT_EQ(refusal(call(R"("id":NaN,"method":"m")")), -32700);
    EXPECT_EQ(refusal(call(R"("id":1e999,"method":"m")")), -32700);
    EXPECT_EQ(refusal("[]"), -32600);
    EXPECT_EQ(refusal("7"), -32600);
    EXPECT_EQ(refusal(call(R"("id":{},"method":"m")")), -32600);
    EXPECT_EQ(refusal(call(R"("id":[1],"method":"m")")), -32600);
    EXPECT_EQ(refusal(call(R"("id":true,"method":"m")")), -32600);
    EXPECT_EQ(refusal(call(R"("id":1,"method":1)")), -32600);
    EXPECT_EQ(refusal(call(R"("id":1)")), -32600);
    EXPECT_EQ(refusal(call(R"("id":1,"method":"m","params":7)")), -32600);
    EXPECT_EQ(refusal(R"({"jsonrpc":"1.0","id":1,"method":"m"})"), -32600);
    EXPECT_EQ(refusal(R"({"jsonrpc":2.0,"id":1,"method":"m"})"), -32600);
    EXPECT_EQ(refusal(R"({"id":1,"method":"m"})"), -32600);
    EXPECT_EQ(refusal(call(R"("id":1,"method":"m")")), 0);
    EXPECT_EQ(refusal(call(R"("id":1,"id":2,"method":"m")")), -32600)
        << "readers would take different ones of a member that appears twice";
}

TEST(JsonRpc, BoundsLengthDepthAndBatch) {
    EXPECT_EQ(refusal(std::string(limits.message_bytes + 1, ' ')), -32600);
    EXPECT_EQ(refusal(std::string(500, '[')), -32600);
    const auto nested = [](std::size_t depth) {
        return call(R"("id":1,"method":"m","params":)" + std::string(depth, '[') +
                    std::string(depth, ']'));
    };
    EXPECT_EQ(refusal(nested(limits.depth - 1)), 0);
    EXPECT_EQ(refusal(nested(limits.depth)), -32600);
    const auto batch = [](std::size_t size) {
        std::string text;
        for (std::size_t i = 0; i < size; ++i)
            text += (i == 0 ? "[" : ",") + call(R"("id":1,"method":"m")");
        return text + "]";
    };
    EXPECT_EQ(parse_rpc(batch(limits.batch), limits).calls.size(), limits.batch);
    EXPECT_EQ(refusal(batch(limits.batch + 1)), -32600);
}

TEST(JsonRpc, WritesAnswersThatAreJson) {
    EXPECT_EQ(json::parse(rpc_result("\"a\"", {{"x", 1}})),
              json::parse(R"({"jsonrpc":"2.0","id":"a","result":{"x":1}})"));
    const json error =
        json::parse(rpc_error("3", {RpcCode::NotFound, "no \xff rake", "look", {}, {}}));
    EXPECT_EQ(error["error"]["code"], -32004);
    EXPECT_EQ(error["error"]["data"], (json{{"kind", "notFound"}, {"hint", "look"}}));
    const auto detail = std::make_shared<const json>(json{{"current", 5}});
    const json stale = json::parse(rpc_error("3", {RpcCode::Stale, "old", "again", {}, detail}));
    EXPECT_EQ(stale["error"]["data"], (json{{"kind", "stale"}, {"hint", "again"}, {"current", 5}}));
    EXPECT_EQ(rpc_batch({}), "");
    EXPECT_EQ(rpc_batch({"1", "2"}), "[1,2]");
    EXPECT_EQ(json::parse(rpc_notification("a.b", json::object()))["method"], "a.b");
}

TEST(JsonRpc, GivesEveryErrorOfTheEngineACodeOfTheContract) {
    using Code = core::Error::Code;
    const auto code = [](Code each) { return static_cast<int>(fault_of({each, "m", "h"}).code); };
    EXPECT_EQ(code(Code::NotFound), -32004);
    EXPECT_EQ(code(Code::OutOfDomain), -32012);
    EXPECT_EQ(code(Code::OutOfTime), -32013);
    EXPECT_EQ(code(Code::OverLimit), -32014);
    EXPECT_EQ(code(Code::Corrupt), -32015);
    EXPECT_EQ(code(Code::Io), -32015);
    EXPECT_EQ(code(Code::Cancelled), -32800);
    EXPECT_EQ(code(Code::InvalidArgument), -32602);
    EXPECT_EQ(fault_of({Code::Unsupported, "m", "h"}).kind, "unsupported");
}

TEST(JsonRpc, SaysOfEveryErrorOverALimitWhichThatIs) {
    using Code = core::Error::Code;
    const core::Result<int> quota = core::over_limit(7, "m", "h");
    EXPECT_EQ(*fault_of(quota.error()).detail, (json{{"limit", 7}}));
    const core::Result<int> memory = core::fail(Code::OverLimit, "m", "h");
    EXPECT_GT((*fault_of(memory.error()).detail)["limit"], 1U << 27) << "the machine's, in bytes";
    EXPECT_EQ(fault_of({Code::NotFound, "m", "h"}).detail, nullptr);
}

} // namespace wakesurf::protocol::json_rpc_test
