// The examples of the JSON-RPC 2.0 specification, section 7, all 15 of them, against the methods they assume.
#include "protocol/api/base/methods.hpp"
#include "server/base/limits.hpp"
#include "server/base/log_text.hpp"
#include "server/net/methods/dispatcher.hpp"
#include "server/net/methods/method.hpp"
#include "tests/support/server/no_datasets.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

namespace wakesurf::server::dispatcher_test {

using nlohmann::json;
using tests::NoDatasets;

namespace {

class IdleLoop final : public Loop {
  public:
    void post(std::function<void()>) override {}

    std::shared_ptr<void> after(std::chrono::milliseconds, std::function<void()>) override {
        return nullptr;
    }
};

std::vector<Method> example_methods() {
    const auto subtract = [](const Call& call, Reply reply) {
        const json& p = call.parameters;
        reply.result(p.is_array() ? p[0].get<int>() - p[1].get<int>()
                                  : p["minuend"].get<int>() - p["subtrahend"].get<int>());
    };
    const auto sum = [](const Call& call, Reply reply) {
        int total = 0;
        for (const json& each : call.parameters)
            total += each.get<int>();
        reply.result(total);
    };
    const std::vector<std::string> terms{"minuend", "subtrahend"};
    constexpr MethodTraits websocket{Role::Viewer, true};
    return {
        {"subtract", {}, terms, subtract},
        {"sum", {}, {}, sum},
        {"update", {}, {}, [](const Call&, Reply reply) { reply.result(json::object()); }},
        {"notify_hello", {}, {}, [](const Call&, Reply reply) { reply.result(json::object()); }},
        {"notify_sum", {}, {}, sum},
        {"get_data",
         {},
         {},
         [](const Call&, Reply reply) {
             reply.result({"hello", 5});
         }},
        {"throws", {}, {}, [](const Call&, Reply) { throw std::runtime_error("/secret/path"); }},
        {"tells_much",
         {},
         {},
         [](const Call&, Reply reply) { reply.result(std::string(1 << 20, 'x')); }},
        {"forgets", {}, {}, [](const Call&, Reply) {}},
        {"on_socket", websocket, {}, [](const Call&, Reply reply) { reply.result(1); }},
    };
}

class DispatcherTest : public testing::Test {
  protected:
    std::string answer(const std::string& text) {
        std::optional<std::string> out;
        dispatcher.dispatch(text, {}, nullptr, [&](std::string given) {
            EXPECT_FALSE(out) << "answered twice";
            out = std::move(given);
        });
        EXPECT_TRUE(out) << "not answered";
        return out.value_or("");
    }

    void expect(const std::string& text, const std::string& expected) {
        json given = json::parse(answer(text));
        strip(given);
        EXPECT_EQ(given, json::parse(expected)) << text;
    }

    /// Leaves of errors what the specification says about them.
    static void strip(json& value) {
        if (value.is_array())
            for (json& each : value)
                strip(each);
        else if (value.contains("error"))
            value["error"] = value["error"]["code"];
    }

    IdleLoop loop;
    ComputePool pool{1};
    Prober prober{loop, pool};
    NoDatasets datasets;
    SystemEntropy entropy;
    SessionDirectory sessions{{loop, pool, datasets, entropy}};
    core::SteadyClock clock;
    Grants grants{{loop, clock, entropy, unix_seconds}};
    Dispatcher dispatcher{
        example_methods(),
        {sessions, datasets, [] { return json::array(); }, prober, grants, clock, loop},
        {}};
};

} // namespace

TEST_F(DispatcherTest, AnswersCallsWithPositionalAndNamedParameters) {
    expect(R"({"jsonrpc":"2.0","method":"subtract","params":[42,23],"id":1})",
           R"({"jsonrpc":"2.0","result":19,"id":1})");
    expect(R"({"jsonrpc":"2.0","method":"subtract","params":[23,42],"id":2})",
           R"({"jsonrpc":"2.0","result":-19,"id":2})");
    expect(
        R"({"jsonrpc":"2.0","method":"subtract","params":{"subtrahend":23,"minuend":42},"id":3})",
        R"({"jsonrpc":"2.0","result":19,"id":3})");
    expect(
        R"({"jsonrpc":"2.0","method":"subtract","params":{"minuend":42,"subtrahend":23},"id":4})",
        R"({"jsonrpc":"2.0","result":19,"id":4})");
}

TEST_F(DispatcherTest, AnswersNotificationsWithNothing) {
    EXPECT_EQ(answer(R"({"jsonrpc":"2.0","method":"update","params":[1,2,3,4,5]})"), "");
    EXPECT_EQ(answer(R"({"jsonrpc":"2.0","method":"foobar"})"), "");
}

TEST_F(DispatcherTest, AnswersFaultsWithTheirCodes) {
    expect(R"({"jsonrpc":"2.0","method":"foobar","id":"1"})",
           R"({"jsonrpc":"2.0","error":-32601,"id":"1"})");
    expect(R"({"jsonrpc":"2.0","method":"foobar,"params":"bar","baz])",
           R"({"jsonrpc":"2.0","error":-32700,"id":null})");
    expect(R"({"jsonrpc":"2.0","method":1,"params":"bar"})",
           R"({"jsonrpc":"2.0","error":-32600,"id":null})");
}

TEST_F(DispatcherTest, AnswersBatches) {
    expect(
        R"([{"jsonrpc":"2.0","method":"sum","params":[1,2,4],"id":"1"},{"jsonrpc":"2.0","method"])",
        R"({"jsonrpc":"2.0","error":-32700,"id":null})");
    expect("[]", R"({"jsonrpc":"2.0","error":-32600,"id":null})");
    expect("[1]", R"([{"jsonrpc":"2.0","error":-32600,"id":null}])");
    expect(
        "[1,2,3]",
        R"([{"jsonrpc":"2.0","error":-32600,"id":null},{"jsonrpc":"2.0","error":-32600,"id":null},
                          {"jsonrpc":"2.0","error":-32600,"id":null}])");
    expect(R"([{"jsonrpc":"2.0","method":"sum","params":[1,2,4],"id":"1"},
               {"jsonrpc":"2.0","method":"notify_hello","params":[7]},
               {"jsonrpc":"2.0","method":"subtract","params":[42,23],"id":"2"},
               {"foo":"boo"},
               {"jsonrpc":"2.0","method":"foo.get","params":{"name":"myself"},"id":"5"},
               {"jsonrpc":"2.0","method":"get_data","id":"9"}])",
           R"([{"jsonrpc":"2.0","result":7,"id":"1"},{"jsonrpc":"2.0","result":19,"id":"2"},
               {"jsonrpc":"2.0","error":-32600,"id":null},{"jsonrpc":"2.0","error":-32601,"id":"5"},
               {"jsonrpc":"2.0","result":["hello",5],"id":"9"}])");
    EXPECT_EQ(answer(R"([{"jsonrpc":"2.0","method":"notify_sum","params":[1,2,4]},
                         {"jsonrpc":"2.0","method":"notify_hello","params":[7]}])"),
              "");
}

TEST_F(DispatcherTest, RefusesWhatTheSpecificationLeavesToImagination) {
    const auto call = [](const std::string& members) {
        return R"({"jsonrpc":"2.0","method":"sum","params":[1],)" + members + "}";
    };
    for (const char* id : {"{}", "[]", "[1]", "true", "false"})
        expect(call(R"("id":)" + std::string(id)), R"({"jsonrpc":"2.0","error":-32600,"id":null})");
    expect(call(R"("id":1.5)"), R"({"jsonrpc":"2.0","result":1,"id":1.5})");
    expect(call(R"("id":null)"), R"({"jsonrpc":"2.0","result":1,"id":null})");
    for (const char* version : {R"("1.0")", "2.0", "null", "2"})
        expect(R"({"method":"sum","id":1,"jsonrpc":)" + std::string(version) + "}",
               R"({"jsonrpc":"2.0","error":-32600,"id":1})");
    expect(R"({"method":"sum","id":1})", R"({"jsonrpc":"2.0","error":-32600,"id":1})");
    for (const char* parameters : {"1", "\"a\"", "true"})
        expect(R"({"jsonrpc":"2.0","method":"sum","id":1,"params":)" + std::string(parameters) +
                   "}",
               R"({"jsonrpc":"2.0","error":-32600,"id":1})");
    const std::string one = call(R"("id":1)");
    expect("[" + one + "," + one + "]",
           R"([{"jsonrpc":"2.0","result":1,"id":1},{"jsonrpc":"2.0","result":1,"id":1}])");
    std::string many = "[" + one;
    for (int i = 0; i < 64; ++i)
        many += "," + one;
    expect(many + "]", R"({"jsonrpc":"2.0","error":-32600,"id":null})");
}

TEST_F(DispatcherTest, SurvivesHandlersThatThrowOrForgetAndLeaksNothing) {
    for (const char* method : {"throws", "forgets"}) {
        const std::string text =
            answer(R"({"jsonrpc":"2.0","id":1,"method":")" + std::string(method) + "\"}");
        EXPECT_EQ(json::parse(text)["error"]["code"], -32603);
        EXPECT_EQ(text.find("secret"), std::string::npos);
    }
}

TEST_F(DispatcherTest, RefusesWhatTheTableDoesNotName) {
    expect(
        R"({"jsonrpc":"2.0","method":"subtract","params":{"minuend":1,"subtrahend":1,"x":1},"id":1})",
        R"({"jsonrpc":"2.0","error":-32602,"id":1})");
    expect(R"({"jsonrpc":"2.0","method":"on_socket","id":1})",
           R"({"jsonrpc":"2.0","error":-32600,"id":1})");
    expect(R"({"jsonrpc":"2.0","method":"rpc.secret","id":1})",
           R"({"jsonrpc":"2.0","error":-32601,"id":1})");
}

TEST(LogText, KeepsPathsOut) {
    EXPECT_EQ(without_paths("cannot open /home/ada/data.raw: no such file"),
              "cannot open (path) no such file");
    EXPECT_EQ(without_paths("[/a/b]"), "(path)");
    EXPECT_EQ(without_paths("plain words"), "plain words");
    EXPECT_EQ(without_paths(""), "");
}

TEST(MethodTable, NamesEveryMethodOfTheContractOnceAndDocumentsIt) {
    IdleLoop loop;
    ComputePool pool{1};
    Prober prober{loop, pool};
    NoDatasets datasets;
    SystemEntropy entropy;
    SessionDirectory sessions{{loop, pool, datasets, entropy}};
    const core::SteadyClock clock;
    Grants grants{{loop, clock, entropy, unix_seconds}};
    const Dispatcher dispatcher{
        method_table(),
        {sessions, datasets, [] { return json::array(); }, prober, grants, clock, loop},
        {}};
    const json document = json::parse(dispatcher.document());
    std::map<std::string, json> methods;
    for (const json& each : document["methods"]) {
        EXPECT_TRUE(methods.emplace(each["name"], each).second) << each["name"] << " twice";
        EXPECT_FALSE(each["summary"].get<std::string>().empty()) << each["name"];
    }
    for (const char* name :
         {"rpc.discover", "server.info", "server.ping", "dataset.list", "dataset.describe",
          "session.create", "session.join", "session.state", "rake.set", "rake.list", "rake.delete",
          "surface.set", "surface.list", "surface.delete", "surface.stop", "surface.wait",
          "surface.subscribe", "surface.unsubscribe", "surface.stats"})
        EXPECT_TRUE(methods.contains(name)) << name;
    EXPECT_EQ(methods["surface.subscribe"]["x-websocketOnly"], true);
}

TEST(MethodTable, HasCodeForEveryMethodThatIsDescribedAndForNoOther) {
    std::set<std::string> described{};
    for (const protocol::MethodDescription& each : protocol::described_methods())
        described.insert(std::string(each.name));
    std::set<std::string> there{"rpc.discover"}; // the dispatcher's own
    for (const Method& each : method_table())
        EXPECT_TRUE(there.insert(each.name).second) << each.name << " twice";
    EXPECT_EQ(there, described);
}

TEST_F(DispatcherTest, AnswersNoBatchWithMoreThanAMessageMayHave) {
    std::string batch = "[";
    for (int id = 0; id < 64; ++id)
        batch += (id == 0 ? "" : ",") +
                 (R"({"jsonrpc":"2.0","method":"tells_much","id":)" + std::to_string(id) + "}");
    const std::string text = answer(batch + "]");
    EXPECT_LT(text.size(), limits::outbox_message_bytes + 64 * 512);
    const json answers = json::parse(text);
    ASSERT_EQ(answers.size(), 64u);
    EXPECT_TRUE(answers[0].contains("result"));
    EXPECT_EQ(answers[63]["id"], 63);
    EXPECT_EQ(answers[63]["error"]["code"], -32014);
    EXPECT_EQ(answers[63]["error"]["data"]["limit"], limits::outbox_message_bytes);
}

} // namespace wakesurf::server::dispatcher_test
