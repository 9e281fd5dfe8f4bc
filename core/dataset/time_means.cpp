#include "core/dataset/time_means.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

constexpr std::size_t grain = 8192;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

} // namespace

std::vector<double> trapezoidal_weights(std::span<const double> times) {
    std::vector<double> weights(times.size(), times.size() == 1 ? 1.0 : 0.0);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        const double half = 0.5 * (times[i + 1] - times[i]);
        weights[i] += half;
        weights[i + 1] += half;
    }
    return weights;
}

std::size_t phase_of(double time, double period, std::size_t phases) {
    const double turns = time / period;
    if (!std::isfinite(turns))
        return 0; // of a period that is nothing beside the time
    const double part = (turns - std::floor(turns)) * static_cast<double>(phases);
    return static_cast<std::size_t>(std::floor(part + 0.5)) % phases;
}

TimeMeans::TimeMeans(std::size_t places, std::size_t components)
    : components_(components), weight_(places), mean_(places * components),
      square_(places * components) {}

void TimeMeans::add(std::span<const float> values, double weight) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places(), grain), [&](const auto& range) {
        for (std::size_t place = range.begin(); place != range.end(); ++place) {
            const auto here = values.subspan(place * components_, components_);
            if (!std::ranges::all_of(here, [](float value) { return std::isfinite(value); }))
                continue;
            const double share = weight / (weight_[place] += weight);
            for (std::size_t i = 0; i < components_; ++i) {
                double& mean = mean_[place * components_ + i];
                const double difference = double{here[i]} - mean;
                mean += difference * share;
                square_[place * components_ + i] += weight * difference * (here[i] - mean);
            }
        }
    });
}

void TimeMeans::add(const TimeMeans& other) {
    for (std::size_t place = 0; place < places(); ++place) {
        if (other.weight_[place] <= 0.0)
            continue;
        const double before = weight_[place];
        const double share = other.weight_[place] / (weight_[place] += other.weight_[place]);
        for (std::size_t i = place * components_; i < (place + 1) * components_; ++i) {
            const double difference = other.mean_[i] - mean_[i];
            mean_[i] += difference * share;
            square_[i] += other.square_[i] + difference * difference * before * share;
        }
    }
}

double TimeMeans::mean(std::size_t place, std::size_t component) const {
    return weight_[place] > 0.0 ? mean_[place * components_ + component] : nothing;
}

double TimeMeans::variance(std::size_t place, std::size_t component) const {
    return weight_[place] > 0.0 ? square_[place * components_ + component] / weight_[place]
                                : nothing;
}

} // namespace wakesurf::core
