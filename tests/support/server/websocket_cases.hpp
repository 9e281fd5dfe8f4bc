// Cases of RFC 6455 in the order of the Autobahn test suite's sections: lengths, pings, reserved bits,
// opcodes, fragments, UTF-8, closing, limits, and how the bytes are cut up on the way. server.ping answers
// with the id of the call, which makes it the echo that such a suite wants.
#pragma once

#include "tests/support/server/websocket_frames.hpp"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace wakesurf::tests::ws {

/// The expected reactions of the server, in order. `close` ends a case.
struct Expected {
    enum class Kind { Pong, Echo, EchoIfSent, ParseError, Close } kind;
    std::string payload; ///< of a pong; the id of an echo
    unsigned code = 0;   ///< of a close
};

struct Case {
    std::string name;
    std::string bytes;
    std::vector<Expected> expected;
    std::size_t chunk = 0; ///< bytes sent at a time; 0: all at once
};

/// Prints the name for failures.
inline void PrintTo(const Case& each, std::ostream* out) {
    *out << each.name;
}

using Cases = std::vector<Case>;

/// Returns a call of server.ping whose text has `size` bytes, padded behind; 0: as short as it is. `id` goes
/// in as raw bytes.
std::string call(const std::string& id, std::size_t size = 0);

/// Returns all cases, each with a name of its own.
Cases all_cases();

} // namespace wakesurf::tests::ws
