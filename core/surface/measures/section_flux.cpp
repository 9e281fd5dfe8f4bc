#include "core/surface/measures/section_flux.hpp"

#include "core/surface/measures/measured.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr double least_pieces = 4.0, most_pieces = 128.0;
/// Samples of one call, of which there are as many as it takes: 12 MB.
constexpr std::size_t samples_at_once = 200'000;

class Samples {
  public:
    Samples(const SurfacePlan& plan, double time, const std::stop_token& stop)
        : plan_(plan), time_(time), stop_(stop) {}

    /// Adds the flux through a small area.
    Result<void> add(const Vec3& place, const Vec3& area) {
        places_.push_back(place);
        areas_.push_back(area);
        return places_.size() < samples_at_once ? Result<void>() : sum_up();
    }

    Result<double> flux() {
        if (auto done = sum_up(); !done)
            return tl::unexpected(done.error());
        return flux_;
    }

  private:
    Result<void> sum_up() {
        const Flow& flow = *plan_.flow;
        std::vector<Vec3> velocity(places_.size());
        const std::vector<double> times(places_.size(), time_);
        if (auto sampled = flow.sample(places_, times, velocity, stop_,
                                       plan_.parameters.interpolation == Interpolation::Smooth);
            !sampled)
            return sampled;
        for (std::size_t i = 0; i < places_.size(); ++i)
            switch (flow.status(places_[i])) {
            case PointStatus::Inside:
                flux_ += glm::dot(velocity[i], areas_[i]);
                break;
            case PointStatus::OutsideDomain:
                return fail(Error::Code::OutOfDomain, "the cross-section leaves the data");
            case PointStatus::InObstacle:
                break;
            }
        places_.clear();
        areas_.clear();
        return {};
    }

    const SurfacePlan& plan_;
    double time_;
    const std::stop_token& stop_;
    std::vector<Vec3> places_, areas_;
    double flux_ = 0.0;
};

Result<double> through_cone(const SurfacePlan& plan,
                            std::span<const Vec3> curve,
                            const Vec3& centre,
                            double time,
                            int pieces,
                            const std::stop_token& stop) {
    Samples samples(plan, time, stop);
    const double away = 0.5 / std::sqrt(3.0); // Gauss's two points of a piece of length 1
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec3 a = curve[i] - centre, b = curve[(i + 1) % curve.size()] - centre;
        const Vec3 twice = glm::cross(a, b), middle = 0.5 * (a + b);
        for (int k = 0; k < pieces; ++k)
            for (const double at : {k + 0.5 - away, k + 0.5 + away}) {
                const double part = at / pieces;
                if (auto added = samples.add(centre + part * middle, 0.5 * part / pieces * twice);
                    !added)
                    return tl::unexpected(added.error());
            }
    }
    return samples.flux();
}

/// Returns the sum of |v x dl| times the error along the curve.
Result<std::vector<double>> by_errors(const SurfacePlan& plan,
                                      std::span<const Vec3> curve,
                                      std::span<const std::vector<double>> errors,
                                      double time,
                                      const std::stop_token& stop) {
    std::vector<Vec3> velocity(curve.size());
    const std::vector<double> times(curve.size(), time);
    if (auto sampled = plan.flow->sample(curve, times, velocity, stop,
                                         plan.parameters.interpolation == Interpolation::Smooth);
        !sampled)
        return tl::unexpected(sampled.error());
    std::vector<double> out;
    for (const std::vector<double>& error : errors) {
        double sum = 0.0, known = 0.0, length = 0.0;
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const std::size_t next = (i + 1) % curve.size();
            const Vec3 along = curve[next] - curve[i];
            const double here = 0.5 * (error[i] + error[next]);
            length += glm::length(along);
            if (!std::isfinite(here))
                continue;
            known += glm::length(along);
            sum += here * glm::length(glm::cross(0.5 * (velocity[i] + velocity[next]), along));
        }
        out.push_back(known > 0.5 * length ? sum : not_known);
    }
    return out;
}

} // namespace

Result<SectionFlux> section_flux(const SurfacePlan& plan,
                                 std::span<const Vec3> curve,
                                 std::span<const std::vector<double>> errors,
                                 double time,
                                 double spacing,
                                 const std::stop_token& stop) {
    Vec3 centre(0.0), area(0.0);
    for (const Vec3& p : curve)
        centre += p / static_cast<double>(curve.size());
    double radius = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec3 a = curve[i] - centre;
        area += 0.5 * glm::cross(a, curve[(i + 1) % curve.size()] - centre);
        radius = std::max(radius, glm::length(a));
    }
    const int pieces =
        static_cast<int>(std::clamp(std::ceil(radius / spacing), least_pieces, most_pieces));
    const auto coarse = through_cone(plan, curve, centre, time, pieces, stop);
    if (!coarse)
        return tl::unexpected(coarse.error());
    const auto fine = through_cone(plan, curve, centre, time, 2 * pieces, stop);
    if (!fine)
        return tl::unexpected(fine.error());
    auto changes = by_errors(plan, curve, errors, time, stop);
    if (!changes)
        return tl::unexpected(changes.error());
    return SectionFlux{*fine, std::abs(*fine - *coarse), *std::move(changes), area};
}

} // namespace wakesurf::core
