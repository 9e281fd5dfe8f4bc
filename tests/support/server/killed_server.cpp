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

std::vector<double> restart_with_sessions(const std::filesystem::path& state,
                                          int sessions,
                                          int surfaces,
                                          int restarts) {
    {
        Life first(state);
        for (int session = 0; session < sessions; ++session) {
            WebSocketClient client(first.server, ""); // each has its own allowance of edits
            const json id = client.result("session.create")["session"];
            for (int each = 0; each < surfaces; ++each) {
                const double x = 0.1 * each;
                const json rake = client.result("rake.set", {{"session", id},
                                                             {"kind", "line"},
                                                             {"points", {{x, -1, 0}, {x, 1, 0}}},
                                                             {"seeds", 16}});
                client.result("surface.set", {{"session", id},
                                              {"rake", rake["rake"]},
                                              {"kind", "stream"},
                                              {"dataset", "lamb-oseen"},
                                              {"from", 0},
                                              {"to", 5}});
            }
        }
        first.server.kill();
    }
    std::vector<double> times;
    for (int restart = 0; restart < restarts; ++restart) {
        Life again(state);
        times.push_back(again.ready_ms);
        const json list = json::parse(
            again.server.rpc(R"({"jsonrpc":"2.0","id":1,"method":"session.list"})"))["result"];
        if (list["sessions"].size() < static_cast<std::size_t>(sessions))
            throw std::runtime_error("sessions are missing");
        again.server.kill();
    }
    return times;
}

} // namespace wakesurf::tests
