// Means over time at many places at once, in one pass: the weighted form of Welford's sums (West, Updating
// mean and variance estimates, 1979), which loses no digits where the mean is much larger than what changes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Returns the weights of the trapezoidal rule: half the way to the times before and after. One time has 1.
/// @param times  strictly increasing
std::vector<double> trapezoidal_weights(std::span<const double> times);

/// Returns which of `phases` equal parts of a period a time is in; that of phase 0 has the multiples of the
/// period in its middle. REQUIRES: period > 0, phases > 0.
std::size_t phase_of(double time, double period, std::size_t phases);

/// Sums at places that have one or more numbers each. Where one of them is not finite, as in a body or
/// outside of the domain, the place does not count at that time. Thread safety: of a value.
class TimeMeans {
  public:
    TimeMeans(std::size_t places, std::size_t components);

    /// Returns the bytes that so many places take.
    static constexpr std::size_t bytes(std::size_t places, std::size_t components) {
        return places * sizeof(double) * (1 + 2 * components);
    }

    /// Adds one time, in the caller's arena. @param values  the components of the first place, then of the
    /// next
    void add(std::span<const float> values, double weight);

    /// Adds all that was added to the other.
    void add(const TimeMeans& other);

    /// Returns the mean of a component. Not a number where nothing was added; so below.
    double mean(std::size_t place, std::size_t component = 0) const;

    /// Returns the mean of the square of the difference from the mean.
    double variance(std::size_t place, std::size_t component = 0) const;

    std::size_t places() const { return weight_.size(); }

    std::size_t components() const { return components_; }

  private:
    std::size_t components_;
    std::vector<double> weight_; ///< one a place
    std::vector<double> mean_;   ///< components of a place, then of the next
    std::vector<double> square_; ///< weighted sums of squares of differences from the mean
};

} // namespace wakesurf::core
