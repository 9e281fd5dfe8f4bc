#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace wakesurf::core {

namespace {

tl::unexpected<Error> refused(const std::string& what, const std::string& hint) {
    return fail(Error::Code::InvalidArgument, what, hint);
}

std::string span_text(double from, double to) {
    return "`from` " + time_text(from) + " and `to` " + time_text(to);
}

/// Their vertices are all there at one time, and there is one such time only in each direction.
Result<void> check_both(const SurfaceParameters& p) {
    const double back = 2.0 * p.from - p.to;
    if (p.kind != SurfaceKind::Stream && p.kind != SurfaceKind::Path)
        return refused("`direction` both is for stream and path surfaces: all of a " +
                           std::string(p.kind == SurfaceKind::Streak ? "streak"
                                       : p.kind == SurfaceKind::Time ? "time"
                                                                     : "level") +
                           " surface is there at one time",
                       "make two surfaces, one in each direction");
    if (p.to > p.from)
        return {};
    return refused("`to` " + time_text(p.to) + " is before `from` " + time_text(p.from) +
                       ", but with `direction` both it is the later end",
                   "give `to` " + time_text(back) +
                       ": the surface goes as long before `from` as after it");
}

Result<void> check_one_way(const SurfaceParameters& p, bool backward) {
    if (backward == (p.to < p.from))
        return {};
    const std::string way = backward ? "backward" : "forward";
    return refused("`direction` is " + way + ", but `to` " + time_text(p.to) +
                       (backward ? " is after" : " is before") + " `from` " + time_text(p.from),
                   "for as long " + way + " give " + span_text(p.from, 2.0 * p.from - p.to) +
                       ", and to go to " + time_text(p.to) + " leave `direction` out");
}

/// A particle is followed so long, without sign.
double longest_age(const SurfaceParameters& p) {
    return std::min(time_span(p), p.life.value_or(time_span(p)));
}

} // namespace

std::string time_text(double time) {
    std::ostringstream text;
    text.precision(12);
    text << time;
    return text.str();
}

bool between(double time, double first, double last) {
    const double way = time - first;
    return way * (last - first) > 0.0 && std::abs(way) <= std::abs(last - first);
}

double time_sign(const SurfaceParameters& p) {
    return p.to < p.from ? -1.0 : 1.0;
}

double time_span(const SurfaceParameters& p) {
    return std::abs(p.to - p.from);
}

Direction direction_of(const SurfaceParameters& p) {
    return p.direction.value_or(p.to < p.from ? Direction::Backward : Direction::Forward);
}

Result<void> check_direction(const SurfaceParameters& p) {
    if (p.kind == SurfaceKind::Level && std::isfinite(p.from) && p.from == p.to)
        return {}; // of one time
    if (!std::isfinite(p.from) || !std::isfinite(p.to) || p.from == p.to)
        return fail(Error::Code::InvalidArgument, "`from` and `to` must be finite and differ",
                    "give the integration time as to - from");
    const Direction direction = direction_of(p);
    return direction == Direction::Both ? check_both(p)
                                        : check_one_way(p, direction == Direction::Backward);
}

std::optional<double> data_end(const Flow& flow, const SurfaceParameters& p) {
    const auto range = flow.time_bounds();
    if (p.kind != SurfaceKind::Path || direction_of(p) != Direction::Both || !range)
        return std::nullopt;
    const double first = (*range)[0];
    return p.from - longest_age(p) < first ? std::optional(first) : std::nullopt;
}

std::vector<double> side_durations(const Flow& flow, const SurfaceParameters& p) {
    const double whole = time_sign(p) * longest_age(p);
    if (direction_of(p) != Direction::Both)
        return {whole};
    const auto end = data_end(flow, p);
    const double back = end ? *end - p.from : -whole;
    return back < 0.0 ? std::vector{whole, back} : std::vector{whole};
}

} // namespace wakesurf::core
