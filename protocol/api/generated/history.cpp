// Made by protocol/api/generate from history.schema.json: do not edit.
#include "protocol/api/generated/history.hpp"

namespace wakesurf::protocol {

void read(CheckedJson& in, HistoryUndo& out) {
    if (in.has("session"))
        out.session = in.text("session", 256);
}

void read(CheckedJson& in, HistoryRedo& out) {
    if (in.has("session"))
        out.session = in.text("session", 256);
}

} // namespace wakesurf::protocol
