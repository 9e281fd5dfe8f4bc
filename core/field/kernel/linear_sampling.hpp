// Velocities of a batch's particles, trilinear in space and linear in time: velocity as in the file, an
// x-pair of nodes a load, which is the best of 14 layouts (docs/measurements.md, The limit of the kernel).
// Twin: cubic_sampling.hpp.
#pragma once

#include "core/field/kernel/stored_nodes.hpp"

namespace wakesurf::core {

/// Velocities of Lanes::together particles, and their slopes along the cell's axes where tangents are
/// carried: those in y, then those in z.
template <class Lanes>
struct KernelSample {
    typename Lanes::Quad value, along_x;
    typename Lanes::Floats along_yz;
};

/// @tparam Places  UniformPlaces or RectilinearPlaces
/// @tparam Nodes   WholeNodes or BrickNodes
template <class Lanes, class Places, class Nodes, bool Unsteady, bool Tangents>
class LinearSampling {
    using Floats = typename Lanes::Floats;
    using Quad = typename Lanes::Quad;
    using Wide = typename Lanes::Wide;
    static constexpr std::size_t row = 8; ///< floats

  public:
    /// Begins a step of lanes 0 to `end`.
    void begin(const StoredPair& field, Rk4Batch& batch, std::size_t end) {
        nodes_.begin(field, batch);
        if constexpr (!Unsteady)
            return;
        // Where all lanes have the same time, the first lane's shares are enough.
        stride_ = batch.straight != 0 ? 0 : row;
        const std::size_t count = batch.straight != 0 ? Lanes::together : end;
        for (std::size_t g = 0; g < count; g += Wide::size) {
            const Wide dt = Wide::load(batch.dt + g);
            const Wide time = Wide::load(batch.start + g) + Wide::load(batch.taken + g) * dt;
            const Wide per_interval = Wide::all(field.per_interval);
            const Wide blend = (time - Wide::all(field.time0)) * per_interval;
            const Wide change = dt * per_interval;
            const Quad later[3] = {blend.narrow(), (blend + Wide::all(0.5) * change).narrow(),
                                   (blend + change).narrow()};
            for (std::size_t at = 0; at < 3; ++at) {
                alignas(64) float share[Wide::size];
                later[at].store(share);
                for (std::size_t i = 0; i < Wide::size && g + i < count; i += Lanes::together) {
                    const Floats whole = Floats::each_of(share + i);
                    whole.store(later_[at] + row * (g + i));
                    (Floats::all(1.0f) - whole).store(earlier_[at] + row * (g + i));
                }
            }
        }
    }

    /// Finds the places of a vector of lanes from `g` on, at the next stage.
    void place(const StoredPair& field,
               Rk4Batch& batch,
               const Places& places,
               std::size_t g,
               const Floats (&cell)[3],
               const Floats (&fraction)[3]) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            fraction[axis].store(fraction_[axis] + g);
        nodes_.take(field, batch, places, g, cell);
    }

    /// The input of a stage's samples, by value, so that it is kept in registers while particles are written.
    class Stage {
      public:
        /// Samples for particle `i` and those that go together with it.
        KernelSample<Lanes> sample(std::size_t i) const {
            std::int64_t at[Lanes::together], then[Lanes::together];
            for (std::size_t k = 0; k < Lanes::together; ++k) {
                at[k] = of_->nodes_.template offset<0>(i + k);
                then[k] = Unsteady ? of_->nodes_.template offset<1>(i + k) : 0;
            }
            const Floats earlier = Floats::load(earlier_ + of_->stride_ * i);
            const Floats later = Floats::load(later_ + of_->stride_ * i);
            const auto row = [&](std::int64_t beyond) {
                if constexpr (Unsteady)
                    return Floats::rows(velocity0_ + beyond, at) * earlier +
                           Floats::rows(velocity1_ + beyond, then) * later;
                else
                    return Floats::rows(velocity0_ + beyond, at);
            };
            const Floats r00 = row(0);
            const Floats r10 = row(y_);
            const Floats r01 = row(z_);
            const Floats r11 = row(yz_);
            const Floats fx = Floats::each_of_quads(&of_->fraction_[0][i]);
            const Floats fy = Floats::each_of(&of_->fraction_[1][i]);
            const Floats fz = Floats::each_of(&of_->fraction_[2][i]);
            const Floats y0 = r10 - r00;
            const Floats y1 = r11 - r01;
            const Floats low = r00 + fy * y0;
            const Floats along_z = r01 + fy * y1 - low;
            const Floats whole = low + fz * along_z;
            const Quad first = whole.first();
            const Quad along_x = whole.second() - first;
            KernelSample<Lanes> result;
            result.value = first + fx.low() * along_x;
            if constexpr (Tangents) {
                const Floats along_y = y0 + fz * (y1 - y0);
                const Floats near = Floats::firsts(along_y, along_z);
                result.along_x = along_x;
                result.along_yz = near + fx * (Floats::seconds(along_y, along_z) - near);
            }
            return result;
        }

      private:
        friend LinearSampling;
        const LinearSampling* of_;
        const float* velocity0_;
        const float* velocity1_;
        std::int64_t y_, z_, yz_; ///< floats between rows
        const float* earlier_;
        const float* later_;
    };

    /// @param time  0: at the step's start, 1: middle, 2: end
    Stage stage(const StoredPair& field, const Rk4Batch&, std::size_t time) const {
        Stage stage;
        stage.of_ = this;
        stage.velocity0_ = Nodes::base(field, field.velocity0);
        stage.velocity1_ = Nodes::base(field, field.velocity1);
        stage.y_ = 3 * static_cast<std::int64_t>(Nodes::strides(field)[1]);
        stage.z_ = 3 * static_cast<std::int64_t>(Nodes::strides(field)[2]);
        stage.yz_ = stage.y_ + stage.z_;
        stage.earlier_ = earlier_[time];
        stage.later_ = later_[time];
        return stage;
    }

  private:
    alignas(64) float fraction_[3][Rk4Batch::most];
    /// Shares of the first time-step and of the second, all over each particle's row: the multiplications
    /// take them from here.
    alignas(64) float earlier_[3][row * Rk4Batch::most];
    alignas(64) float later_[3][row * Rk4Batch::most];
    std::size_t stride_; ///< from a particle's to the next one's
    Nodes nodes_;
};

} // namespace wakesurf::core
