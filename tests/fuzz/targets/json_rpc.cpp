// The envelope: text to calls, and each of them back to text as an error and as an answer.
#include "protocol/api/json_rpc.hpp"

#include "protocol/api/base/json_text.hpp"
#include "tests/fuzz/targets/all.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::fuzz {

namespace {

void run(Input input) {
    const auto message = protocol::parse_rpc(text_of(input), {});
    demand(!message.calls.empty(), "each message is at least one call, valid or refused");
    std::vector<std::string> answers;
    for (const auto& call : message.calls) {
        const std::string id = call.id.value_or(std::string(protocol::null_id));
        const std::string answer = call.refused ? protocol::rpc_error(id, *call.refused)
                                                : protocol::rpc_result(id, *call.parameters);
        demand(
            protocol::parse_json(answer, {.bytes = std::size_t{1} << 20, .depth = 64}).has_value(),
            "an answer is JSON");
        answers.push_back(answer);
    }
    if (message.batch)
        demand(!protocol::rpc_batch(answers).empty(), "a batch with calls has answers");
}

std::vector<std::string> seeds() {
    return {
        R"({"jsonrpc":"2.0","id":1,"method":"server.ping"})",
        R"({"jsonrpc":"2.0","id":"κ€😀","method":"rake.set","params":{"kind":"line","points":[[0,0,0],[1e300,-0.5,1]]}})",
        R"([{"jsonrpc":"2.0","id":null,"method":"a"},{"foo":"boo"},1,{"jsonrpc":"2.0","method":"b","params":[]}])",
        R"({"jsonrpc":"2.0","id":1.5e2,"method":"x","params":{"a":[[[[[{}]]]]],"b":"\u0000\ud83d\ude00"}})",
        R"({"jsonrpc":"1.0","id":{},"method":7,"params":"no"})",
        "[]",
        "",
        "\xef\xbb\xbf{}",
    };
}

} // namespace

const Target json_rpc_target{"json_rpc", run, seeds, true};

} // namespace wakesurf::fuzz
