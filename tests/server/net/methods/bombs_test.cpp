// Requests made to take the server's memory or time: each is answered with a typed error as fast as any other request,
// nothing piles up, and everybody else is served.
#include "tests/support/server/processor_time.hpp"
#include "tests/support/server/record_shapes.hpp"
#include "tests/support/server/server_suite.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::tests::bombs_test {

using nlohmann::json;

namespace {

constexpr std::chrono::milliseconds patience{100}; ///< of all the server's processors
constexpr std::size_t memory_budget = 64;          ///< MiB that all of it together may add

std::string repeat(const std::string& part, std::size_t times) {
    std::string out;
    for (std::size_t i = 0; i < times; ++i)
        out += part;
    return out;
}

std::string list_of(const std::string& item, std::size_t count) {
    return "[" + repeat(item + ",", count - 1) + item + "]";
}

std::string call(const std::string& method, const std::string& parameters) {
    return R"({"jsonrpc":"2.0","id":1,"method":")" + method + R"(","params":)" + parameters + "}";
}

std::string rake(const std::string& more) {
    return call("rake.set", R"({"session":"main",)" + more + "}");
}

std::string line(const std::string& more) {
    return rake(R"("kind":"line","points":[[0,0,0],[1,0,0]],)" + more);
}

class Bombs : public ServerSuite {
  protected:
    static void SetUpTestSuite() {
        start({"flow:lamb-oseen"});
        for (int i = 0; i < 20; ++i)
            ping();
        before_ = resident();
        const json made = json::parse(server_->rpc(line(R"("seeds":8)")));
        rake_ = made["result"]["rake"];
    }

    void TearDown() override {
        ping();
        ASSERT_TRUE(server_->running());
        EXPECT_LT(resident(), before_ + memory_budget) << "MiB resident";
    }

    static void ping() {
        const std::string answer = server_->rpc(call("server.ping", "{}"));
        EXPECT_EQ(answer, R"({"jsonrpc":"2.0","id":1,"result":{}})");
    }

    /// MiB
    static std::size_t resident() {
        std::ifstream status("/proc/" + std::to_string(server_->pid()) + "/status");
        for (std::string word; status >> word;)
            if (std::size_t kibibytes = 0; word == "VmRSS:" && status >> kibibytes)
                return kibibytes >> 10;
        return 0;
    }

    /// Runs `act` and says when the server computed for longer than a request may.
    template <class Act>
    static void at_little_cost(const std::string& what, Act act) {
        const auto before = processor_time_of(server_->pid());
        act();
        EXPECT_LT(processor_time_of(server_->pid()) - before, patience) << what;
    }

    static std::string surface(const std::string& more) {
        return call("surface.set", R"({"session":"main","rake":")" + rake_ +
                                       R"(","kind":"stream","dataset":"lamb-oseen",)" + more + "}");
    }

    static std::size_t before_;
    static std::string rake_;
};

std::size_t Bombs::before_ = 0;
std::string Bombs::rake_;

/// An error a client can act on.
void expect_typed(const json& answer, const std::string& what) {
    ASSERT_TRUE(answer.contains("error")) << what << "\n" << answer.dump().substr(0, 300);
    const json& error = answer["error"];
    EXPECT_TRUE(error["code"].is_number_integer()) << what;
    EXPECT_TRUE(error["data"]["kind"].is_string() && error["data"]["hint"].is_string())
        << what << "\n"
        << error;
    EXPECT_EQ(error["code"] == -32014, error["data"].value("limit", json()).is_number())
        << what << ": which limit?\n"
        << error;
    EXPECT_NE(error["code"], -32603) << what << ": the server did not expect this\n" << error;
    EXPECT_LT(error["message"].get<std::string>().size(), 500u) << what;
}

} // namespace

TEST_F(Bombs, InCallsAreRefusedWithATypedErrorAtOnce) {
    const std::string deep = repeat(R"({"a":)", 5000) + "1" + repeat("}", 5000);
    const std::string long_text(60000, 'x');
    const std::vector<std::tuple<std::string, std::string, std::set<int>>> table{
        {"-10^18 seeds", line(R"("seeds":-1000000000000000000)"), {-32602}},
        {"1e300 seeds", line(R"("seeds":1e300)"), {-32602}},
        {"two numbers of seeds, the second huge", line(R"("seeds":8,"seeds":1e9)"), {-32600}},
        {"NaN as text", line(R"("seeds":"NaN")"), {-32602}},
        {"Infinity", line(R"("seeds":Infinity)"), {-32700}},
        {"1e999", line(R"("seeds":1e999)"), {-32700}},
        {"coordinates of 1e38",
         rake(R"("kind":"line","points":[[1e38,0,0],[-1e38,0,0]],"seeds":4096)"),
         {-32602, -32012}},
        {"coordinates that cancel out",
         rake(R"("kind":"line","points":[[1e-320,0,0],[0,1e-320,0]],"seeds":4096)"),
         {-32602}},
        {"a name of 60,000 characters", line(R"("seeds":8,"name":")" + long_text + "\""), {-32602}},
        {"a session of 60,000 characters",
         call("rake.list", R"({"session":")" + long_text + "\"}"),
         {-32602, -32004}},
        {"a method of 60,000 characters", call(long_text, "{}"), {-32601}},
        {"a parameter of 60,000 characters",
         call("server.ping", R"({")" + long_text + R"(":1})"),
         {-32602}},
        {"10,000 unknown parameters",
         [] {
             std::string all = "{";
             for (int i = 0; i < 4000; ++i)
                 all += "\"p" + std::to_string(i) + "\":" + std::to_string(i) + ",";
             return call("server.ping", all + "\"q\":1}");
         }(),
         {-32602}},
        {"60,000 brackets", std::string(60000, '['), {-32600, -32700}},
        {"5,000 objects in each other", call("server.ping", deep), {-32600}},
        {"5,000 objects in the id",
         R"({"jsonrpc":"2.0","method":"server.ping","id":)" + deep + "}",
         {-32600}},
        {"an id that is an object",
         R"({"jsonrpc":"2.0","method":"server.ping","id":{"a":1}})",
         {-32600}},
        {"an id that is a list", R"({"jsonrpc":"2.0","method":"server.ping","id":[1]})", {-32600}},
        {"an id that is true", R"({"jsonrpc":"2.0","method":"server.ping","id":true})", {-32600}},
        {"an id beyond all numbers",
         R"({"jsonrpc":"2.0","method":"nothing","id":1e999})",
         {-32700}},
        {"a batch of 65", list_of(call("server.ping", "{}"), 65), {-32600}},
        {"a batch of 30,000 ones", list_of("1", 30000), {-32600}},
        {"an empty batch", "[]", {-32600}},
        {"nothing", " ", {-32700}},
        {"65,000 blanks", std::string(65000, ' '), {-32700}},
        {"60,000 quotation marks", std::string(60000, '"'), {-32700}},
        {"a number of 60,000 digits",
         call("server.ping", R"({"x":)" + std::string(60000, '9') + "}"),
         {-32700, -32602}},
        {"a lone surrogate", line(R"("seeds":8,"name":"\ud800")"), {-32700}},
        {"surrogates the wrong way round", line(R"("seeds":8,"name":"\udc00\ud800")"), {-32700}},
        {"text that is not UTF-8", line("\"seeds\":8,\"name\":\"\xff\xfe\""), {-32700}},
        {"an overlong slash", line("\"seeds\":8,\"name\":\"\xc0\xaf\""), {-32700}},
        {"a NUL in a name", line(R"("seeds":8,"name":"a\u0000b")"), {-32602}},
        {"a real NUL", std::string("{\0}", 3), {-32700}},
        {"a comment", "/* */" + call("server.ping", "{}"), {-32700}},
        {"two messages in one", call("server.ping", "{}") + call("server.ping", "{}"), {-32700}},
        {"10^18 quads", surface(R"("from":0,"to":1,"maxQuads":1000000000000000000)"), {-32602}},
        {"no quads", surface(R"("from":0,"to":1,"maxQuads":0)"), {-32602}},
        {"the end of time", surface(R"("from":0,"to":1e300)"), {-32602, -32013}},
        {"the beginning of time", surface(R"("from":-1e300,"to":0)"), {-32602, -32013}},
        {"10,000 fields",
         surface(R"("from":0,"to":1,"fields":)" + list_of("\"p\"", 10000)),
         {-32602}},
        {"a field of 60,000 characters",
         surface(R"("from":0,"to":1,"fields":[")" + long_text + "\"]"),
         {-32602}},
        {"a sweep to nowhere", surface(R"("from":0,"to":1,"sweep":[1e300,1e300,1e300])"), {-32602}},
        {"an unknown accuracy", surface(R"("from":0,"to":1,"accuracy":"exactest")"), {-32602}},
        {"a wait for ever",
         call("surface.wait", R"({"session":"main","surface":"s1","timeoutMs":1e300})"),
         {-32602}},
        {"a wait for less than nothing",
         call("surface.wait", R"({"session":"main","surface":"s1","timeoutMs":-1})"),
         {-32602}},
        {"a probe at 8,000 points",
         call("probe.sample", R"({"dataset":"lamb-oseen","time":0,"fields":[],"points":)" +
                                  list_of("[0,1,2]", 7000) + "}"),
         {-32602}},
        {"a probe at 1e300",
         call("probe.sample",
              R"({"dataset":"lamb-oseen","time":1e300,"fields":[],"points":[[0,0,1e300]]})"),
         {-32602, -32013}},
        {"a probe of 10,000 fields",
         call("probe.sample", R"({"dataset":"lamb-oseen","time":0,"points":[[0,0,0]],"fields":)" +
                                  list_of("\"p\"", 10000) + "}"),
         {-32602}},
        {"a dataset that is a path",
         call("dataset.describe", R"({"dataset":"../../../../etc/passwd"})"),
         {-32004}},
        {"a dataset that is to be made",
         call("dataset.describe", R"({"dataset":"flow:abc?A=1e300"})"),
         {-32004}},
        {"a subscription without a WebSocket",
         call("surface.subscribe", R"({"session":"main","surface":"s1"})"),
         {-32600}},
    };
    ASSERT_GE(table.size(), 40u);
    for (const RecordShape& each : rake_shapes())
        if (each.always_bad)
            at_little_cost(each.what, [&] {
                const json answer = json::parse(server_->rpc(rake(each.parameters)));
                expect_typed(answer, each.what);
            });
    for (const auto& [what, text, codes] : table)
        at_little_cost(what, [&, &what = what, &text = text, &codes = codes] {
            const json answer = json::parse(server_->rpc(text));
            expect_typed(answer, what);
            if (!answer.contains("error"))
                return;
            EXPECT_TRUE(codes.contains(answer["error"].value("code", 0)))
                << what << "\n"
                << answer.dump().substr(0, 300);
        });
}

TEST_F(Bombs, OfWrongTypesInEveryParameterOfEveryMethodAreRefused) {
    const json methods = json::parse(
        http(server_->port(), "GET", "/openrpc.json", server_->bearer()).body)["methods"];
    const std::vector<std::string> values{
        "null", "true", "-1",     "1e300", "1e-320",           "\"\"", R"("\u0000")", "\"../..\"",
        "[]",   "[[]]", "[null]", "{}",    R"({"a":{"a":[]}})"};
    std::size_t asked = 0;
    const auto before = processor_time_of(server_->pid());
    for (const json& method : methods)
        for (const json& parameter : method["params"])
            for (const std::string& value : values) {
                const std::string name = parameter["name"];
                const std::string text = call(method["name"], "{\"" + name + "\":" + value + "}");
                const json answer = json::parse(server_->rpc(text));
                if (!answer.contains("result"))
                    expect_typed(answer, text);
                ++asked;
            }
    EXPECT_GT(asked, 500u);
    EXPECT_LT((processor_time_of(server_->pid()) - before) / asked, patience);
}

TEST_F(Bombs, OfManyRecordsEndAtAQuotaThatIsNamed) {
    WebSocketClient client(*server_, "");
    const std::string session = client.result("session.create", {{"name", "full"}})["session"];
    client.result("session.join", {{"session", session}});
    const auto fill = [&](const std::string& method, const json& parameters, int most) {
        for (int i = 0; i <= most; ++i) {
            const json answer = client.call(method, parameters);
            if (answer.contains("result"))
                continue;
            expect_typed(answer, method);
            EXPECT_EQ(answer["error"]["code"], -32014) << answer;
            EXPECT_EQ(answer["error"]["data"]["limit"], i) << answer;
            return i;
        }
        return -1;
    };
    const json points{{0.5, 0, 0}, {1, 0, 0}};
    const json wanted{{"kind", "line"}, {"points", points}, {"seeds", 2}};
    const json limits = client.result("server.info")["limits"];
    EXPECT_EQ(fill("rake.set", wanted, 2000), limits["rakes"]);
    const std::string first = client.result("rake.list")["rakes"][0]["rake"];
    EXPECT_EQ(fill("surface.set",
                   {{"rake", first},
                    {"kind", "stream"},
                    {"dataset", "lamb-oseen"},
                    {"from", 0},
                    {"to", 0.01}},
                   2000),
              limits["surfaces"]);
    const std::string surface = client.result("surface.list")["surfaces"][0]["surface"];
    for (int i = 0; i < 200; ++i)
        client.result("surface.subscribe", {{"surface", surface}});
}

TEST_F(Bombs, OfManyWaitsEndAtAQuotaThatIsNamed) {
    WebSocketClient client(*server_);
    const std::string surface = client.result("surface.set", {{"rake", rake_},
                                                              {"kind", "stream"},
                                                              {"dataset", "lamb-oseen"},
                                                              {"from", 0},
                                                              {"to", 0.01}})["surface"];
    client.result("surface.wait", {{"surface", surface}, {"timeoutMs", 60000}});
    int refused = 0;
    std::vector<int> ids;
    for (int i = 0; i < 100; ++i) {
        ids.push_back(client.next_id());
        client.send({{"jsonrpc", "2.0"},
                     {"id", ids.back()},
                     {"method", "surface.wait"},
                     {"params", {{"surface", surface}, {"epoch", 4000000}, {"timeoutMs", 300}}}});
    }
    for (const int id : ids) {
        const json answer = client.answer(id);
        if (!answer.contains("error"))
            continue;
        ++refused;
        expect_typed(answer, "surface.wait");
        EXPECT_EQ(answer["error"]["code"], -32014);
        EXPECT_EQ(answer["error"]["data"]["limit"], 64);
    }
    EXPECT_EQ(refused, 36);
    EXPECT_EQ(client.result("server.info")["limits"]["waiters"], 64);
}

TEST_F(Bombs, OfASurfaceThatIsTooLargeEndAtTheQuadsItMayHave) {
    WebSocketClient client(*server_);
    json rake{{"kind", "line"}, {"points", {{0.5, 0, 0}, {1, 0, 0}}}, {"seeds", 4096}};
    rake["rake"] = client.result("rake.set", rake)["rake"];
    json answer = client.call("surface.set", {{"rake", rake["rake"]},
                                              {"kind", "streak"},
                                              {"dataset", "lamb-oseen"},
                                              {"from", 0},
                                              {"to", 1},
                                              {"maxQuads", 100}});
    ASSERT_TRUE(answer.contains("result")) << answer;
    answer = client.result("surface.wait",
                           {{"surface", answer["result"]["surface"]}, {"timeoutMs", 60000}});
    EXPECT_LE(answer["quads"], 100) << answer;
    EXPECT_GT(answer["quads"], 0) << answer;
    EXPECT_EQ(answer["coarsened"], true) << answer;
    client.result("rake.delete", {{"rake", rake["rake"]}});
}

TEST_F(Bombs, OfManyProbesEndAtAQuotaThatIsNamed) {
    const std::string probe =
        call("probe.sample", R"({"dataset":"lamb-oseen","time":0,"fields":[],"points":)" +
                                 list_of("[0,1,2]", 100) + "}");
    const json answers = json::parse(server_->rpc(list_of(probe, 64)));
    ASSERT_EQ(answers.size(), 64u);
    for (const json& each : answers)
        if (each.contains("error")) {
            expect_typed(each, "probe.sample");
            EXPECT_EQ(each["error"]["code"], -32014);
            EXPECT_EQ(each["error"]["data"]["limit"], 32) << each;
        }
    EXPECT_TRUE(std::any_of(answers.begin(), answers.end(),
                            [](const json& each) { return each.contains("result"); }));
}

} // namespace wakesurf::tests::bombs_test
