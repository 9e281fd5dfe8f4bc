#include "server/sessions/session_clock.hpp"

#include "server/base/limits.hpp"
#include "server/sessions/records/record_entries.hpp"

#include <cmath>

namespace wakesurf::server {

std::optional<double> SessionClock::time() const {
    if (!record_.playing || !record_.time)
        return record_.time;
    const std::chrono::duration<double> run = wall_.now() - since_;
    const double time = *record_.time + run.count() * record_.speed;
    const double from = *record_.from;
    const double to = *record_.to;
    if (time < to)
        return time;
    return record_.loop ? from + std::fmod(time - from, to - from) : to;
}

protocol::ClockRecord SessionClock::record() const {
    protocol::ClockRecord now = record_;
    now.time = time();
    return now;
}

void SessionClock::start_from(double time) {
    record_.time = time;
    since_ = wall_.now();
}

void SessionClock::set(std::optional<double> time) {
    record_.time = time;
    since_ = wall_.now();
    if (!time)
        record_.playing = false;
    if (record_.playing && (*time < *record_.from || *time >= *record_.to))
        record_.playing = false;
    told();
}

core::Result<void> SessionClock::play(const protocol::PlaySetting& setting,
                                      std::optional<std::array<double, 2>> natural) {
    protocol::ClockRecord next = record();
    const auto choose = [](std::optional<double> asked, std::optional<double> before,
                           std::optional<double> usual) {
        return asked ? asked : before ? before : usual;
    };
    next.from =
        choose(setting.from, record_.from, natural ? std::optional((*natural)[0]) : std::nullopt);
    next.to = choose(setting.to, record_.to, natural ? std::optional((*natural)[1]) : std::nullopt);
    if (!next.from || !next.to)
        return core::fail(core::Error::Code::InvalidArgument,
                          "`from` and `to` are missing: no surface of the session moves",
                          "give both, or make a path, streak or time surface first");
    if (!(*next.from < *next.to))
        return core::fail(core::Error::Code::InvalidArgument, "`to` must be later than `from`",
                          "give both to play a different part");
    next.speed = setting.speed.value_or(record_.speed);
    next.loop = setting.loop.value_or(record_.loop);
    if (auto sound = check_clock(next); !sound) // a surface may reach further than a clock
        return sound;
    next.playing = true;
    const double start =
        next.time && *next.time >= *next.from && *next.time < *next.to ? *next.time : *next.from;
    record_ = next;
    start_from(start);
    told();
    return {};
}

void SessionClock::pause() {
    if (!record_.playing)
        return;
    record_.time = time();
    record_.playing = false;
    told();
}

void SessionClock::restore(const protocol::ClockRecord& kept) {
    record_ = kept;
    record_.playing = false;
}

void SessionClock::told() {
    ticker_.reset();
    last_ = record_.time.value_or(0.0);
    events_.changed();
    events_.moved(true);
    if (record_.playing)
        ticker_ = loop_.after(limits::clock_tick, [this] { tick(); });
}

void SessionClock::tick() {
    const double now = *time();
    if (now >= *record_.to)
        return pause();
    const bool jumped = now < last_; // it began again
    last_ = now;
    events_.moved(jumped);
    ticker_ = loop_.after(limits::clock_tick, [this] { tick(); });
}

} // namespace wakesurf::server
