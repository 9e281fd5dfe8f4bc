#include "tests/support/server/killed_server.hpp"

#include "tests/support/server/edit_ledger.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <chrono>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace wakesurf::tests {

using nlohmann::json;
using std::chrono::steady_clock;

namespace {

constexpr std::size_t most_edits = 60;
constexpr std::size_t window = 8;         ///< unanswered edits
constexpr std::size_t latest_kill = 4000; ///< microseconds after the last edit

/// False when the connection has ended.
bool take_answer(WebSocketClient& client, EditLedger& ledger, std::size_t& open) {
    for (;;) {
        const WebSocketClient::Message message = client.receive();
        if (message.opcode == 0 || message.opcode == 8)
            return false;
        if (message.opcode != 1)
            continue;
        const json text = json::parse(message.payload);
        if (!text.contains("id"))
            continue;
        if (text.contains("result") && text["result"].value("durable", false) != true)
            throw std::runtime_error("an edit is not durable: " + message.payload);
        ledger.answered(text["id"], text);
        --open;
        return true;
    }
}

/// Edits until a random moment, kills, and takes the answers that were on their way.
void edit_and_kill(ServerProcess& server, EditLedger& ledger) {
    WebSocketClient client(server);
    std::size_t open = 0;
    for (std::size_t edits = 1 + ledger.random()() % most_edits; edits > 0; --edits) {
        const EditLedger::Edit edit = ledger.next();
        client.send({{"jsonrpc", "2.0"},
                     {"id", edit.number},
                     {"method", edit.method},
                     {"params", edit.parameters}});
        for (++open; open >= window;)
            if (!take_answer(client, ledger, open))
                throw std::runtime_error("the server ended by itself");
    }
    // Any point of the last edits' way: parsed, applied, in a transaction, synced, answered.
    std::this_thread::sleep_for(std::chrono::microseconds(ledger.random()() % latest_kill));
    server.kill();
    while (open > 0 && take_answer(client, ledger, open)) {
    }
}

} // namespace

KillReport kill_under_edits(const std::filesystem::path& state, std::uint64_t seed, int kills) {
    KillReport report;
    EditLedger ledger(seed);
    for (int life = 0; life <= kills; ++life) {
        const auto start = steady_clock::now();
        ServerProcess server(
            {"flow:lamb-oseen", "--state", state.string(), "--log-level", "error"});
        const json answer = json::parse(server.rpc(
            R"({"jsonrpc":"2.0","id":1,"method":"session.state","params":{"session":"main"}})"));
        const std::chrono::duration<double, std::milli> ready = steady_clock::now() - start;
        report.ready_ms.push_back(ready.count());
        auto wrong = ledger.settle(answer.at("result"));
        std::move(wrong.begin(), wrong.end(), std::back_inserter(report.wrong));
        if (life == kills)
            break;
        edit_and_kill(server, ledger);
        ++report.kills;
    }
    report.answered = ledger.answers();
    return report;
}

} // namespace wakesurf::tests
