// Made by protocol/api/generate from history.schema.json: do not edit.
#include "protocol/api/generated/history.hpp"

namespace wakesurf::protocol {

void read(CheckedJson& in, HistoryUndo& out) {
    out.session = in.text_if("session", 256);
}

void read(CheckedJson& in, HistoryRedo& out) {
    out.session = in.text_if("session", 256);
}

} // namespace wakesurf::protocol
