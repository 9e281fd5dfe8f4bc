// Advances many particles at once over one field, in parallel. Each is a pure function of where it is, so the result
// is the same for any number of threads.
#pragma once

#include "core/integrate/advance_particle.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <stop_token>

namespace wakesurf::core {

/// Advances those that have not yet reached `to` (in the direction of `sign`: +1 or -1). Returns false if `stop` fired.
template <CarryingField Field>
bool advance_particles(const Field& field,
                       const Particles& p,
                       double to,
                       int sign,
                       const AdvanceOptions& options,
                       const std::stop_token& stop) {
    std::atomic<bool> whole{true};
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, p.count(), 256), [&](const auto& range) {
                if (stop.stop_requested())
                    whole = false;
                if (!whole.load(std::memory_order_relaxed))
                    return;
                for (std::size_t i = range.begin(); i != range.end(); ++i) {
                    if (p.end[i] != CurveEnd::Running || sign * (to - p.time[i]) <= 0.0)
                        continue;
                    ParticleState at{{p.position[i], {}, {}}, p.time[i], p.end[i]};
                    if (p.tangents()) {
                        at.carried.along_s = p.along_s[i];
                        at.carried.along_t = p.along_t[i];
                    }
                    advance_particle(field, at, to, options, p.tangents());
                    p.position[i] = at.carried.position;
                    p.time[i] = at.time;
                    p.end[i] = at.end;
                    if (p.tangents()) {
                        p.along_s[i] = at.carried.along_s;
                        p.along_t[i] = at.carried.along_t;
                    }
                }
            });
    });
    return whole;
}

} // namespace wakesurf::core
