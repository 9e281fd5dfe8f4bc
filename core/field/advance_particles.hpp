// Advances many particles at once over one field, in parallel. Each is a pure function of where it is, so the result
// is the same for any number of threads.
#pragma once

#include "core/field/field_in_series.hpp"
#include "core/integrate/advance_particle.hpp"
#include "core/integrate/cursor_of.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <stop_token>

namespace wakesurf::core {

/// Calls `advance(begin, end)` for ranges of particles. Returns false if `stop` fired. Isolated: a thread that waits here
/// takes no work of another surface.
template <class Advance>
bool in_ranges(std::size_t count, const std::stop_token& stop, const Advance& advance) {
    std::atomic<bool> whole{true};
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
            if (stop.stop_requested())
                whole = false;
            if (whole.load(std::memory_order_relaxed))
                advance(range.begin(), range.end());
        });
    });
    return whole;
}

/// True for those that move on towards `to` (in the direction of `sign`: +1 or -1).
inline bool still_to_go(const Particles& p, std::size_t i, double to, int sign) {
    return p.end[i] == CurveEnd::Running && sign * (to - p.time[i]) > 0.0;
}

inline ParticleState take_out(const Particles& p, std::size_t i) {
    ParticleState at{{p.position[i], Vec3(0.0), Vec3(0.0)}, p.time[i], p.end[i]};
    if (p.tangents()) {
        at.carried.along_s = p.along_s[i];
        at.carried.along_t = p.along_t[i];
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
    }
}

/// Advances those that have not yet reached `to`. Returns false if `stop` fired.
template <CarryingField Field>
bool advance_particles(const Field& field,
                       const Particles& p,
                       double to,
                       int sign,
                       const AdvanceOptions& options,
                       const std::stop_token& stop) {
    const auto carry = [&](ParticleState& at) {
        if constexpr (FieldInSeries<Field>) {
            if (options.method == AdvanceOptions::Method::Dopri5)
                return advance_in_series(field, at, to, options, p.tangents());
        }
        advance_particle(cursor_of(field), at, to, options, p.tangents());
    };
    return in_ranges(p.count(), stop, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) {
            if (!still_to_go(p, i, to, sign))
                continue;
            ParticleState at = take_out(p, i);
            carry(at);
            put_back(p, i, at);
        }
    });
}

} // namespace wakesurf::core
