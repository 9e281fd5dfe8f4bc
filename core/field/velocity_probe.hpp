// Velocities of up to a batch of particles at one time, by the kernel that carries them: in float, and the
// same bits when they arrive as later.
#pragma once

#include "core/field/stored_pair.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace wakesurf::core {

/// Keeps references. @tparam Field  as of RefillBatch
template <class Field>
class VelocityProbe {
  public:
    VelocityProbe(const Field& field, const StoredPair& pair, Rk4Kernel kernel, double time)
        : pair_(stored_pair_at(field, pair, time)), kernel_(kernel), time_(time) {
        if constexpr (std::is_same_v<Field, CubicSampler>) {
            const auto shares = field.shares(time);
            for (auto& at : share_)
                std::transform(shares.begin(), shares.end(), at.begin(),
                               [](double share) { return static_cast<float>(share); });
        }
    }

    /// Fills batch.velocity where the particles are. Overwrites their start and taken steps.
    void operator()(Rk4Batch& batch) const {
        std::fill_n(batch.start, Rk4Batch::most, time_);
        std::fill_n(batch.taken, Rk4Batch::most, 0.0);
        batch.straight = 1;
        if constexpr (std::is_same_v<Field, CubicSampler>)
            batch.share_of_steps = &share_[0][0];
        batch.velocity_only = true;
        kernel_(pair_, batch, false);
        batch.velocity_only = false;
    }

    static Vec3f of(const Rk4Batch& batch, std::size_t lane) {
        const float* v = batch.velocity[lane];
        return {v[0], v[1], v[2]};
    }

  private:
    StoredPair pair_;
    Rk4Kernel kernel_;
    double time_;
    std::array<std::array<float, 4>, 3> share_{};
};

} // namespace wakesurf::core
