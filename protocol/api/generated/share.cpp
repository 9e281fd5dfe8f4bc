// Made by protocol/api/generate from share.schema.json: do not edit.
#include "protocol/api/generated/share.hpp"

#include "protocol/api/generated/limits.hpp"

namespace wakesurf::protocol {

void read(CheckedJson& in, SessionShare& out) {
    out.session = in.text_if("session", 256);
    out.role = in.text("role");
    if (out.role != "viewer" && out.role != "editor" && out.role != "host")
        in.fault("role", "must be viewer, editor or host");
    out.expires_in.given = in.given("expiresIn");
    out.expires_in.value = in.count_if("expiresIn", 1, limits::grant_seconds);
}

void read(CheckedJson& in, SessionUnshare& out) {
    out.session = in.text_if("session", 256);
    out.grant = in.text("grant", 256);
    out.children = in.flag_or("children", false);
}

void read(CheckedJson& in, SessionSetRole& out) {
    out.session = in.text_if("session", 256);
    out.participant = in.text("participant", 256);
    out.role = in.text("role");
    if (out.role != "viewer" && out.role != "editor" && out.role != "host")
        in.fault("role", "must be viewer, editor or host");
}

void read(CheckedJson& in, SessionKick& out) {
    out.session = in.text_if("session", 256);
    out.participant = in.text("participant", 256);
}

} // namespace wakesurf::protocol
