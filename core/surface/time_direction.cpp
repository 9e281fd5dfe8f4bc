#include "core/surface/time_direction.hpp"

#include <cmath>
#include <sstream>
#include <string>

namespace wakesurf::core {

namespace {

tl::unexpected<Error> refused(const std::ostringstream& what, const std::ostringstream& hint) {
    return fail(Error::Code::InvalidArgument, what.str(), hint.str());
}

const char* word(SurfaceKind kind) {
    return kind == SurfaceKind::Streak ? "streak" : "time";
}

/// Their vertices are all there at one time, and there is one such time only in each direction.
Result<void> check_both(const SurfaceParameters& p) {
    std::ostringstream what, hint;
    if (p.kind == SurfaceKind::Streak || p.kind == SurfaceKind::Time) {
        what << "'direction' both is for stream and path surfaces: all of a " << word(p.kind)
             << " surface is there at one time";
        hint << "make two surfaces: one with 'from' " << p.from << " and 'to' " << p.to
             << ", one with 'from' " << p.from << " and 'to' " << 2.0 * p.from - p.to;
        return refused(what, hint);
    }
    if (p.to > p.from)
        return {};
    what << "'to' " << p.to << " is before 'from' " << p.from
         << ", but with 'direction' both it is the later end";
    hint << "give 'to' " << 2.0 * p.from - p.to << ": the surface goes as long before 'from'";
    return refused(what, hint);
}

Result<void> check_release_end(const SurfaceParameters& p) {
    if (!p.release_until)
        return {};
    const double released = time_sign(p) * (*p.release_until - p.from);
    if (released > 0.0 && released <= time_span(p))
        return {};
    return fail(Error::Code::InvalidArgument, "'releaseUntil' must lie between 'from' and 'to'",
                "leave it out to release until 'to'");
}

} // namespace

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
    if (!std::isfinite(p.from) || !std::isfinite(p.to) || p.from == p.to)
        return fail(Error::Code::InvalidArgument, "'from' and 'to' must be finite and differ",
                    "give the integration time as to - from");
    const Direction direction = direction_of(p);
    if (direction == Direction::Both) {
        if (auto sound = check_both(p); !sound)
            return sound;
    } else if (const bool backward = direction == Direction::Backward;
               backward != (p.to < p.from)) {
        std::ostringstream what, hint;
        what << "'direction' is " << (backward ? "backward" : "forward") << ", but 'to' " << p.to
             << (backward ? " is after" : " is before") << " 'from' " << p.from;
        hint << "for as long " << (backward ? "backward" : "forward") << " give 'from' " << p.from
             << " and 'to' " << 2.0 * p.from - p.to << ", and to go to " << p.to
             << " leave 'direction' out";
        return refused(what, hint);
    }
    return check_release_end(p);
}

std::optional<double> data_end(const Flow& flow, const SurfaceParameters& p) {
    const auto range = flow.time_range();
    if (p.kind != SurfaceKind::Path || direction_of(p) != Direction::Both || !range)
        return std::nullopt;
    const double first = (*range)[0];
    return p.from - time_span(p) < first ? std::optional(first) : std::nullopt;
}

std::vector<double> side_durations(const Flow& flow, const SurfaceParameters& p) {
    const double whole = p.to - p.from;
    if (direction_of(p) != Direction::Both)
        return {whole};
    const auto end = data_end(flow, p);
    const double back = end ? *end - p.from : -whole;
    return back < 0.0 ? std::vector{whole, back} : std::vector{whole};
}

} // namespace wakesurf::core
