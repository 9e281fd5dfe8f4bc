// Made by protocol/api/generate from session.schema.json: do not edit.
#include "protocol/api/generated/session.hpp"

#include "protocol/api/base/colour_text.hpp"
#include "protocol/api/generated/limits.hpp"

namespace wakesurf::protocol {

void read(CheckedJson& in, SessionCreate& out) {
    out.name = in.text_or("name", "", limits::name_bytes);
}

void read(CheckedJson& in, SessionFork& out) {
    out.session = in.text_if("session", 256);
    out.name = in.text_or("name", "", limits::name_bytes);
}

void read(CheckedJson& in, SessionList& out) {
    out.trash = in.flag_or("trash", false);
}

void read(CheckedJson& in, SessionJoin& out) {
    out.session = in.text_if("session", 256);
    out.name = in.text_or("name", "", limits::name_bytes);
    if (in.has("colour")) {
        out.colour = in.text("colour", 256);
        if (out.colour->empty())
            out.colour.reset();
        if (out.colour && !is_colour(*out.colour))
            in.fault("colour", "must be written #rrggbb");
    }
    out.resume_token = in.text_if("resumeToken", 256);
    out.last_seq = in.count_if("lastSeq", 0, 9007199254740992);
}

void read(CheckedJson& in, SessionRename& out) {
    out.session = in.text_if("session", 256);
    out.name = in.text("name", limits::name_bytes);
}

void read(CheckedJson& in, SessionSetUnits& out) {
    out.session = in.text_if("session", 256);
    out.length = in.text("length", limits::unit_bytes);
    out.time = in.text("time", limits::unit_bytes);
}

void read(CheckedJson& in, SessionDelete& out) {
    out.session = in.text("session", 256);
    out.forever = in.flag_or("forever", false);
}

void read(CheckedJson& in, SessionRestore& out) {
    out.session = in.text("session", 256);
}

void read(CheckedJson& in, SessionImport& out) {
    out.file = in.object_text("file", limits::message_bytes);
    out.name = in.text_or("name", "", limits::name_bytes);
}

void read(CheckedJson& in, SessionThumbnail& out) {
    out.session = in.text_if("session", 256);
    out.image = in.text("image", limits::message_bytes);
}

} // namespace wakesurf::protocol
