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

/// A server that has reported its restored sessions.
struct Life {
    explicit Life(const std::filesystem::path& state)
        : server({"flow:lamb-oseen", "--state", state.string(), "--log-level", "error"}),
          found(
              json::parse(
                  server.rpc(
                      R"({"jsonrpc":"2.0","id":1,"method":"session.state","params":{"session":"main"}})"))
                  .at("result")) {}

    steady_clock::time_point start = steady_clock::now();
    ServerProcess server;
    json found;
    double ready_ms =
        std::chrono::duration<double, std::milli>(steady_clock::now() - start).count();
};

/// Returns false if the connection has ended.
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

/// Edits until a random moment, kills, and takes the pending answers.
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
    // The kill hits any stage of the last edits: parsed, applied, in a transaction, synced, answered.
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
        Life now(state);
        report.ready_ms.push_back(now.ready_ms);
        auto wrong = ledger.settle(now.found);
        std::move(wrong.begin(), wrong.end(), std::back_inserter(report.wrong));
        if (life == kills)
            break;
        edit_and_kill(now.server, ledger);
        ++report.kills;
    }
    report.answered = ledger.answers();
    return report;
}

} // namespace wakesurf::tests
