// Made by protocol/api/generate from subscription.schema.json: do not edit.
#include "protocol/api/generated/subscription.hpp"

#include "protocol/api/generated/limits.hpp"

namespace wakesurf::protocol {

void read(CheckedJson& in, UpdatePlace& out) {
    out.epoch = static_cast<std::uint32_t>(in.count("epoch", 0, 4294967295));
    out.seq = static_cast<std::uint32_t>(in.count("seq", 0, 4294967295));
}

void read(CheckedJson& in, SurfaceStats& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
}

void read(CheckedJson& in, SurfaceWait& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
    if (const auto number = in.count_if("epoch", 0, 4294967295))
        out.epoch = static_cast<std::uint32_t>(*number);
    out.timeout_ms = in.count("timeoutMs", 0, limits::wait_ms);
    out.work_done_token = in.token_if("workDoneToken", true);
}

void read(CheckedJson& in, SurfaceSubscribe& out) {
    out.session = in.text_if("session", 256);
    out.surface = in.text("surface", 256);
    if (in.has("from")) {
        out.from.emplace();
        in.inside("from", [&](CheckedJson& inner) { read(inner, *out.from); });
    }
}

void read(CheckedJson& in, SurfaceUnsubscribe& out) {
    out.session = in.text_if("session", 256);
    if (const auto number = in.count_if("subscription", 0, 4294967295))
        out.subscription = static_cast<std::uint32_t>(*number);
    out.surface = in.text_if("surface", 256);
}

void read(CheckedJson& in, FrameAck& out) {
    out.subscription = static_cast<std::uint32_t>(in.count("subscription", 0, 4294967295));
    if (const auto number = in.count_if("epoch", 0, 4294967295))
        out.epoch = static_cast<std::uint32_t>(*number);
    out.seq = static_cast<std::uint32_t>(in.count("seq", 0, 4294967295));
}

} // namespace wakesurf::protocol
