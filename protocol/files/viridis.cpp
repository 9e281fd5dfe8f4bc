#include "protocol/files/viridis.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::protocol {

namespace {

/// The coefficients of Matt Zucker's fit of the table (CC0), constant first.
constexpr double coefficients[3][7] = {
    {0.2777273272234177, 0.1050930431085774, -0.3308618287255563, -4.634230498983486,
     6.228269936347081, 4.776384997670288, -5.435455855934631},
    {0.005407344544966578, 1.404613529898575, 0.214847559468213, -5.799100973351585,
     14.17993336680509, -13.74514537774601, 4.645852612178535},
    {0.3340998053353061, 1.384590162594685, 0.09509516302823659, -19.33244095627987,
     56.69055260068105, -65.35303263337234, 26.3124352495832}};

} // namespace

std::array<std::uint8_t, 3> viridis(double value) {
    const double x = value > 0.0 ? std::min(value, 1.0) : 0.0; // NaN is not above 0
    std::array<std::uint8_t, 3> out{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        for (std::size_t k = 7; k-- > 0;)
            sum = sum * x + coefficients[channel][k];
        out[channel] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(sum, 0.0, 1.0)));
    }
    return out;
}

} // namespace wakesurf::protocol
