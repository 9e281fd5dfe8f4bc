// Who may come in: a request's first line, its headers and its body, as a client wrote them. No bytes get past the gate
// without the token, and nothing gets past it under a name that is not the server's.
#include "server/net/gate.hpp"

#include "tests/fuzz/targets/all.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <algorithm>

namespace wakesurf::fuzz {

namespace {

class ZeroEntropy final : public server::Entropy {
  public:
    void fill(std::span<std::byte> out) override {
        std::fill(out.begin(), out.end(), std::byte{7});
    }
};

const std::string token(64, 't');

struct Doorway {
    ZeroEntropy entropy;
    server::HandClock clock;
    server::HandLoop loop{clock};
    server::Grants grants{{loop, clock, entropy, [] { return std::int64_t{0}; }}};
    server::Gate gate{
        {token, "127.0.0.1", 8080, {"https://viewer.example"}}, entropy, clock, grants};
};

std::string_view line_of(std::string_view& rest) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const auto line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return line;
}

/// `METHOD PATH`, lines of `name: value`, an empty line, the body.
server::HttpRequest request_of(std::string_view text) {
    server::HttpRequest request;
    const auto first = line_of(text);
    const auto space = std::min(first.find(' '), first.size());
    request.method = first.substr(0, space);
    request.path = first.substr(std::min(space + 1, first.size()));
    for (auto line = line_of(text); !line.empty(); line = line_of(text)) {
        const auto colon = line.find(": ");
        if (colon != line.npos)
            request.headers.emplace_back(line.substr(0, colon), line.substr(colon + 2));
    }
    request.body = text;
    request.upgrade = request.header("upgrade") == "websocket";
    return request;
}

void run(Input input) {
    Doorway door;
    const auto text = text_of(input);
    const auto request = request_of(text);
    const bool knows = text.find(token) != text.npos;
    demand(!door.gate.check(request) || knows, "no one comes in without the token");
    if (!door.gate.check_open(request)) {
        const auto host = server::host_name(request.header("host"));
        demand(host.has_value(), "a request that is let in names a host");
    }
    demand(!door.gate.login(request, {request.body, request.path}) || request.body == token,
           "no one logs in without the token");
}

std::vector<std::string> seeds() {
    return {
        "GET /ws\nhost: 127.0.0.1:8080\nauthorization: Bearer " + token +
            "\nupgrade: websocket\n\n",
        "POST /rpc\nhost: localhost:8080\norigin: http://localhost:8080\nsec-websocket-protocol: "
        "wakesurf.v1, wakesurf.login.abc.1.2..d\nupgrade: websocket\n\n{}",
        "POST /api/v1/login\nhost: [::1]:8080\norigin: https://viewer.example\n\n" + token,
        "GET /\nhost: evil.example\norigin: null\n\n",
        "GET /healthz\nhost: 127.0.0.1.\nhost: two\n\n",
    };
}

} // namespace

const Target gate_target{"gate", run, seeds};

} // namespace wakesurf::fuzz
