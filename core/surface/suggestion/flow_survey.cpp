#include "core/surface/suggestion/flow_survey.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr int survey_points = 32'768;
constexpr int finer_survey =
    8; ///< times as many points, up to `most_points`, where none is in fluid
constexpr int most_points = 3'000'000;
constexpr int least_along = 3, most_along = 256;
/// If the mean velocity is less than this part of the mean speed, the flow that enters on one side does not
/// leave on the other.
constexpr double going_through = 0.4;
/// A turning flow counts so much less at a corner of the domain than in the middle.
constexpr double corner_loss = 0.4;

bool usable(const Vec3& v) {
    return finite(v);
}

/// The difference of velocity along an axis over two boxes, or one at the border and beside what is not
/// fluid.
Vec3 slope(const FlowSurvey& survey, const std::array<int, 3>& at, std::size_t axis) {
    const SurveyLattice& lattice = survey.lattice;
    std::array<int, 3> low = at;
    std::array<int, 3> high = at;
    low[axis] = std::max(0, at[axis] - 1);
    high[axis] = std::min(lattice.count[axis] - 1, at[axis] + 1);
    if (survey.solid[lattice.index(low)] != 0)
        low = at;
    if (survey.solid[lattice.index(high)] != 0)
        high = at;
    const int apart = high[axis] - low[axis];
    if (apart == 0)
        return Vec3(0.0);
    return (survey.velocity[lattice.index(high)] - survey.velocity[lattice.index(low)]) /
           (apart * lattice.step()[static_cast<int>(axis)]);
}

} // namespace

std::array<int, 3> SurveyLattice::place(std::size_t index) const {
    const int at = static_cast<int>(index);
    return {at % count[0], at / count[0] % count[1], at / count[0] / count[1]};
}

Vec3 SurveyLattice::centre(const std::array<int, 3>& at) const {
    return domain.lo + step() * (Vec3(at[0], at[1], at[2]) + 0.5);
}

std::array<int, 3> SurveyLattice::box_of(const Vec3& point) const {
    std::array<int, 3> at{};
    for (int k = 0; k < 3; ++k) {
        const double along = (point[k] - domain.lo[k]) / step()[k];
        at[static_cast<std::size_t>(k)] = std::clamp(static_cast<int>(std::floor(along)), 0,
                                                     count[static_cast<std::size_t>(k)] - 1);
    }
    return at;
}

SurveyLattice survey_lattice(const Box& domain, int points) {
    const Vec3 extent = domain.extent();
    // The longest side decides; a thin one takes its few boxes whatever their shape.
    std::array<int, 3> order{0, 1, 2};
    std::ranges::sort(order, [&](int a, int b) { return extent[a] < extent[b]; });
    SurveyLattice lattice{domain, {}};
    double left = points;
    double volume = 1.0;
    for (const int k : order)
        volume *= std::max(extent[k], 1e-300);
    for (std::size_t i = 0; i < 3; ++i) {
        const int k = order[i];
        const double side = std::pow(volume / left, 1.0 / static_cast<double>(3 - i));
        const int count =
            std::clamp(static_cast<int>(std::round(extent[k] / side)), least_along, most_along);
        lattice.count[static_cast<std::size_t>(k)] = count;
        left = std::max(1.0, left / count);
        volume /= std::max(extent[k], 1e-300);
    }
    return lattice;
}

std::vector<std::uint8_t> not_fluid(const Flow& flow, const SurveyLattice& lattice) {
    std::vector<std::uint8_t> solid(lattice.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, solid.size(), 512), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                solid[i] = flow.status(lattice.centre(lattice.place(i))) != PointStatus::Inside;
        });
    return solid;
}

bool FlowSurvey::through() const {
    return speed > 0.0 && glm::length(mean) > going_through * speed;
}

int FlowSurvey::axis() const {
    int most = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(mean[k]) > std::abs(mean[most]))
            most = k;
    return most;
}

Result<FlowSurvey> survey_flow(const Flow& flow, double time, std::stop_token stop) {
    FlowSurvey survey{survey_lattice(flow.domain(), survey_points), {}, {}};
    survey.solid = not_fluid(flow, survey.lattice);
    // A narrow passage that slants through its box may lie between all of the middles.
    for (int points = finer_survey * survey_points;
         points <= most_points && std::ranges::find(survey.solid, 0) == survey.solid.end();
         points *= finer_survey) {
        survey.lattice = survey_lattice(flow.domain(), points);
        survey.solid = not_fluid(flow, survey.lattice);
    }
    std::vector<Vec3> places;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < survey.solid.size(); ++i)
        if (survey.solid[i] == 0) {
            places.push_back(survey.lattice.centre(survey.lattice.place(i)));
            index.push_back(i);
        }
    std::vector<Vec3> sampled(places.size());
    const std::vector<double> times(places.size(), time);
    if (auto done = flow.sample(places, times, sampled, stop); !done)
        return tl::unexpected(done.error());
    std::vector<std::uint8_t> gap(places.size());
    if (auto marked = flow.mark_gaps(places, times, gap, stop); !marked)
        return tl::unexpected(marked.error());
    survey.velocity.assign(survey.solid.size(), Vec3(0.0));
    double count = 0.0;
    for (std::size_t i = 0; i < sampled.size(); ++i) {
        survey.solid[index[i]] = gap[i];
        if (gap[i] != 0 || !usable(sampled[i]))
            continue;
        survey.velocity[index[i]] = sampled[i];
        survey.mean += sampled[i];
        survey.speed += glm::length(sampled[i]);
        count += 1.0;
    }
    if (count > 0.0) {
        survey.mean /= count;
        survey.speed /= count;
    }
    return survey;
}

Vec3 vorticity_in(const FlowSurvey& survey, const std::array<int, 3>& at) {
    const Vec3 dx = slope(survey, at, 0);
    const Vec3 dy = slope(survey, at, 1);
    const Vec3 dz = slope(survey, at, 2);
    return {dy.z - dz.y, dz.x - dx.z, dx.y - dy.x};
}

Rotation strongest_rotation(const FlowSurvey& survey) {
    const SurveyLattice& lattice = survey.lattice;
    std::vector<Vec3> vorticity(lattice.size(), Vec3(0.0));
    for (std::size_t i = 0; i < lattice.size(); ++i)
        if (survey.solid[i] == 0)
            vorticity[i] = vorticity_in(survey, lattice.place(i));
    Rotation best;
    double most = -1.0;
    const Vec3 extent = lattice.domain.extent();
    for (std::size_t i = 0; i < lattice.size(); ++i) {
        if (survey.solid[i] != 0)
            continue;
        const Vec3 place = lattice.centre(lattice.place(i));
        const Vec3 off = 2.0 * (place - 0.5 * (lattice.domain.lo + lattice.domain.hi)) /
                         glm::max(extent, Vec3(1e-300));
        const double counts =
            glm::length(vorticity[i]) * (1.0 - corner_loss * glm::dot(off, off) / 3.0);
        if (counts > most) {
            most = counts;
            const double longest = std::max({extent.x, extent.y, extent.z});
            best = {place, vorticity[i], survey.velocity[i],
                    survey.speed > 0.0 ? 0.5 * glm::length(vorticity[i]) * longest / survey.speed
                                       : 0.0};
        }
    }
    return best;
}

} // namespace wakesurf::core
