// Made by protocol/api/generate from server.schema.json: do not edit.
#include "protocol/api/generated/server.hpp"

namespace wakesurf::protocol {

void read(CheckedJson& in, CancelRequest& out) {
    out.id = in.token("id", false);
}

} // namespace wakesurf::protocol
