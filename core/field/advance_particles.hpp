// Advances many particles at once over one field, in parallel. Each is a pure function of where it is, so the
// result is the same for any number of threads.
#pragma once

#include "core/base/for_each_index.hpp"
#include "core/dataset/missing_bricks.hpp"
#include "core/field/field_in_series.hpp"
#include "core/field/look_ahead.hpp"
#include "core/integrate/advance_particle.hpp"
#include "core/integrate/cursor_of.hpp"

#include <algorithm>
#include <atomic>
#include <stop_token>

namespace wakesurf::core {

/// Calls `advance(begin, end)` for ranges of particles, which are small: the few that are traced again have
/// the longest ways. Returns false if `stop` fired.
template <class Advance>
bool in_ranges(std::size_t count,
               const std::stop_token& stop,
               const Advance& advance,
               std::size_t least = 16) {
    std::atomic<bool> whole{true};
    for_each_range(count, least, [&](std::size_t begin, std::size_t end) {
        if (stop.stop_requested())
            whole = false;
        if (whole.load(std::memory_order_relaxed))
            advance(begin, end);
    });
    return whole;
}

struct NothingAhead {
    void operator()(const auto&, std::size_t) const {}
};

// Looks ahead for at most so many of a surface's particles: they are much nearer to each other than bricks
// are large.
inline constexpr std::size_t enough_ahead = 4096;

/// Calls `advance(view, begin, end)` with a view of the field each: the field itself or a copy, or a cursor
/// that serves a block of as many particles whatever the number of threads. Where values were missing it is
/// called again: it leaves the particles that met them as they were. Returns as in_ranges, and false where
/// what is missing cannot be had.
/// @param ahead  `ahead(view, i)` says of some of them what will be missing next
template <class Field, class Advance, class Ahead = NothingAhead>
bool in_blocks(const Field& field,
               std::size_t count,
               const std::stop_token& stop,
               const Advance& advance,
               std::size_t least = 16,
               MissingBricks::Again again = MissingBricks::Again::Restart,
               const Ahead& ahead = {}) {
    if constexpr (FieldWithCursor<Field>) {
        const std::size_t block = std::clamp<std::size_t>(count / 64, 4, 64);
        const auto advance_blocks = [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end; ++i)
                advance(field.cursor(), i * block, std::min((i + 1) * block, count));
        };
        return in_ranges((count + block - 1) / block, stop, advance_blocks,
                         std::max<std::size_t>(least / block, 1));
    } else if constexpr (PagedField<Field>) {
        const auto advance_range = [&](std::size_t begin, std::size_t end) {
            const auto with_view = [&](std::size_t from, std::size_t to) {
                const Field view = field;
                advance(view, begin + from, begin + to);
            };
            return in_ranges(end - begin, stop, with_view, least);
        };
        const auto look_ahead_in = [&](std::size_t begin, std::size_t end) {
            const Field view = field;
            const std::size_t stride = (end - begin) / enough_ahead + 1;
            for (std::size_t i = begin; i < end; i += stride)
                ahead(view, i);
        };
        return MissingBricks::in_rounds(field.missing(), count, stop, again, advance_range,
                                        look_ahead_in);
    } else {
        const auto advance_range = [&](std::size_t begin, std::size_t end) {
            advance(field, begin, end);
        };
        return in_ranges(count, stop, advance_range, least);
    }
}

/// Returns true for particles that move on towards `to` (in the direction of `sign`: +1 or -1).
inline bool still_to_go(const Particles& p, std::size_t i, double to, int sign) {
    return p.end[i] == CurveEnd::Running && sign * (to - p.time[i]) > 0.0;
}

inline ParticleState take_out(const Particles& p, std::size_t i) {
    ParticleState at{{p.position[i], Vec3(0.0), Vec3(0.0)}, p.time[i], p.end[i]};
    if (p.tangents()) {
        at.carried.along_s = p.along_s[i];
        at.carried.along_t = p.along_t[i];
        if (!p.expansion.empty())
            at.carried.expansion = double(p.expansion[i]);
    }
    return at;
}

inline void put_back(const Particles& p, std::size_t i, const ParticleState& at) {
    p.position[i] = at.carried.position;
    p.time[i] = at.time;
    p.end[i] = at.end;
    if (p.tangents()) {
        p.along_s[i] = at.carried.along_s;
        p.along_t[i] = at.carried.along_t;
        if (!p.expansion.empty())
            p.expansion[i] = static_cast<float>(at.carried.expansion);
    }
}

/// Returns where a particle will be, for in_blocks.
inline auto ahead_of(const Particles& p, int sign) {
    return [&p, sign](const auto& view, std::size_t i) {
        if (p.end[i] == CurveEnd::Running)
            look_ahead(view, p.position[i], p.time[i], sign);
    };
}

/// Advances those that have not yet reached `to`. Returns false if `stop` fired.
template <CarryingField Field>
bool advance_particles(const Field& field,
                       const Particles& p,
                       double to,
                       int sign,
                       const AdvanceOptions& options,
                       const std::stop_token& stop) {
    const auto advance_each = [&](const auto& view, std::size_t begin, std::size_t end,
                                  const auto& carry) {
        for (std::size_t i = begin; i != end; ++i) {
            if (!still_to_go(p, i, to, sign))
                continue;
            ParticleState at = take_out(p, i);
            restart(view, p.cell, i);
            carry(at);
            if (take_missed(view))
                continue;
            put_back(p, i, at);
            keep_cell(view, p.cell, i);
        }
    };
    if constexpr (FieldInSeries<Field>) {
        if (options.method == AdvanceOptions::Method::Dopri5) {
            std::atomic<bool> whole{true};
            const auto block = [&](const auto& view, std::size_t begin, std::size_t end) {
                advance_each(view, begin, end, [&](ParticleState& at) {
                    if (!advance_in_series(view, at, to, options, p.tangents(), stop))
                        whole = false;
                });
            };
            return in_blocks(field, p.count(), stop, block, 16, MissingBricks::Again::Restart,
                             ahead_of(p, sign)) &&
                   whole;
        }
    }
    const auto block = [&](const auto& view, std::size_t begin, std::size_t end) {
        advance_each(view, begin, end, [&](ParticleState& at) {
            advance_particle(view, at, to, options, p.tangents());
        });
    };
    return in_blocks(field, p.count(), stop, block, 16, MissingBricks::Again::Restart,
                     ahead_of(p, sign));
}

} // namespace wakesurf::core
