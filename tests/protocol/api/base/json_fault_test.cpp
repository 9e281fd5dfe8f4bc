#include "protocol/api/base/json_text.hpp"
#include "protocol/api/json_rpc.hpp"

#include <gtest/gtest.h>

namespace wakesurf::protocol::json_fault_test {

namespace {

std::string fault(const std::string& text) {
    const RpcMessage message = parse_rpc(text, {65536, 32, 64});
    EXPECT_EQ(message.calls.size(), 1u);
    EXPECT_TRUE(message.calls.at(0).refused);
    EXPECT_EQ(message.calls.at(0).refused->code, RpcCode::ParseError);
    EXPECT_FALSE(message.calls.at(0).refused->hint.empty());
    return message.calls.at(0).refused->message;
}

std::string call(const std::string& parameters) {
    return R"({"jsonrpc":"2.0","id":1,"method":"rake.set","params":{)" + parameters + "}}";
}

} // namespace

TEST(JsonFault, NamesTheParameterThatIsNoNumberInJson) {
    for (const std::string word : {"NaN", "Infinity", "-Infinity", "nan", "inf", "-inf"}) {
        EXPECT_EQ(fault(call(R"("points":[[0,1,2],[3,)" + word + "]]")),
                  "`points[1][1]` is " + word + ", which JSON cannot represent");
        EXPECT_EQ(fault(call(R"("seeds":9,"to":)" + word)),
                  "`to` is " + word + ", which JSON cannot represent");
    }
    EXPECT_EQ(fault(call(R"("view":{"camera":[1,NaN]})")),
              "`view.camera[1]` is NaN, which JSON cannot represent");
    EXPECT_EQ(fault("[" + call(R"("a":1)") + "," + call(R"("to":NaN)") + "]"),
              "`to` is NaN, which JSON cannot represent");
    EXPECT_EQ(fault("NaN"), "the text is NaN, which JSON cannot represent");
}

TEST(JsonFault, TakesTheStartOfATextInQuotesForNoNumber) {
    for (const std::string word : {"inf", "is NaN"})
        EXPECT_EQ(fault(R"({"params":{"to":1,")" + word), "the text is not valid JSON from byte " +
                                                              std::to_string(19 + word.size()) +
                                                              " on, in `to`");
}

TEST(JsonFault, SaysWhereOtherTextsEndToBeJson) {
    const std::string text = call(R"("to":nothing)");
    EXPECT_EQ(fault(text), "the text is not valid JSON from byte " +
                               std::to_string(text.find("othing")) + " on, in `to`")
        << "an n may begin null";
    EXPECT_EQ(fault(""), "the text is not valid JSON from byte 0 on");
    EXPECT_EQ(fault("{"), "the text is not valid JSON from byte 1 on");
    EXPECT_EQ(fault("\xff\xfe"), "the text is not valid JSON from byte 0 on");
}

TEST(JsonFault, NamesANumberThatIsTooLarge) {
    EXPECT_EQ(fault(call(R"("points":[[0,-1e999,2]])")),
              "`points[0][1]` is beyond 1.8e308, the largest number there is");
}

TEST(JsonFault, CutsNamesThatAreLong) {
    EXPECT_LT(fault(R"({")" + std::string(5000, 'x') + R"(":NaN})").size(), 200u);
}

TEST(JsonFault, NamesAMemberThatIsThereTwice) {
    const auto twice = [](const std::string& text) {
        const RpcMessage message = parse_rpc(text, {65536, 32, 64});
        EXPECT_TRUE(message.calls.at(0).refused) << text;
        EXPECT_EQ(message.calls.at(0).refused->code, RpcCode::InvalidRequest) << text;
        return message.calls.at(0).refused->message;
    };
    EXPECT_EQ(twice(R"({"jsonrpc":"2.0","id":1,"method":"server.ping","method":"session.create"})"),
              "`method` appears twice");
    EXPECT_EQ(twice(call(R"("seeds":8,"seeds":9)")), "`seeds` appears twice");
    EXPECT_EQ(twice(call(R"("view":{"a":{":":1}},"list":[{"x":1},{"x":2,"y":[],"x":3}])")),
              "`list[1].x` appears twice");
    EXPECT_EQ(twice(call(R"("seeds":8,"\u0073eeds":9)")), "`seeds` appears twice")
        << "the same name in other letters";
    EXPECT_EQ(twice("[" + call("") + "," + call(R"("a":1,"a":1)") + "]"), "`a` appears twice");
    EXPECT_FALSE(
        parse_rpc(call(R"("a":{"a":":\":"},"b":{"a":1},"c":[{"a":1},{"a":1}])"), {65536, 32, 64})
            .calls.at(0)
            .refused);
}

} // namespace wakesurf::protocol::json_fault_test
