#include "core/surface/suggestion/line_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace wakesurf::core {

namespace {

constexpr int line_looks = 64; ///< along a line, for where it is in fluid
/// A part of a stretch that is left to the domain's sides.
constexpr double left_free = 0.03;

/// Says how much comes into the domain in a box: its speed, if there is no fluid upstream of it.
double entering_at(const FlowSurvey& survey, std::size_t box) {
    const Vec3& v = survey.velocity[box];
    const double speed = glm::length(v);
    if (survey.solid[box] != 0 || !(speed > 0.0))
        return 0.0;
    const SurveyLattice& lattice = survey.lattice;
    const Vec3 step = lattice.step();
    const Vec3 pace = glm::abs(v) / step;
    const Vec3 before = lattice.centre(lattice.place(box)) -
                        1.01 * v / std::max(std::max(pace.x, pace.y), std::max(pace.z, 1e-300));
    const bool within = glm::all(glm::greaterThan(before, lattice.domain.lo)) &&
                        glm::all(glm::lessThan(before, lattice.domain.hi));
    return within && survey.solid[lattice.index(lattice.box_of(before))] == 0 ? 0.0 : speed;
}

/// A stretch of a straight line in fluid.
struct Stretch {
    std::array<Vec3, 2> line{};
    double swept = 0.0; ///< speed across it times its length
};

/// Returns the stretch through a point of fluid, at most `half` to each side.
Stretch stretch_through(const Flow& flow,
                        const FlowSurvey& survey,
                        const Vec3& point,
                        const Vec3& direction,
                        double half) {
    const Vec3 step = direction * (2.0 * half / line_looks);
    Stretch out{{point, point}, 0.0};
    for (const double sign : {-1.0, 1.0}) {
        Vec3& end = out.line[sign < 0.0 ? 0 : 1];
        for (int i = 0; i < line_looks / 2; ++i) {
            const Vec3 next = end + sign * step;
            if (flow.status(next) != PointStatus::Inside)
                break;
            end = next;
            const SurveyLattice& lattice = survey.lattice;
            const Vec3& v = survey.velocity[lattice.index(lattice.box_of(next))];
            out.swept += glm::length(glm::cross(v, step));
        }
        end -= left_free * (end - point); // not on the side itself
    }
    return out;
}

} // namespace

std::optional<FluidLine>
find_line(const Flow& flow, const FlowSurvey& survey, double longest, double sweep) {
    constexpr std::size_t tried = 48;
    const SurveyLattice& lattice = survey.lattice;
    std::vector<std::pair<double, std::size_t>> places;
    double most = 0.0;
    for (std::size_t i = 0; i < lattice.size(); ++i)
        if (survey.solid[i] == 0) {
            places.emplace_back(entering_at(survey, i), i);
            most = std::max(most, places.back().first);
        }
    if (!(most > 0.0))
        for (auto& [amount, box] : places)
            amount = glm::length(survey.velocity[box]);
    std::ranges::stable_sort(places, std::greater<>{}, &std::pair<double, std::size_t>::first);
    // Evenly over those with at least half of the most: the very first may all be beside one edge.
    std::size_t count = 0;
    while (count < places.size() && places[count].first >= 0.5 * places.front().first)
        ++count;
    const auto worth = [&](const Stretch& one) {
        return survey.speed > 0.0 ? one.swept : glm::length(one.line[1] - one.line[0]);
    };
    Stretch best;
    Vec3 velocity(0.0);
    for (std::size_t k = 0; k < count; k += std::max<std::size_t>(1, count / tried)) {
        const Vec3 point = lattice.centre(lattice.place(places[k].second));
        for (int n = 14; n < 27; ++n) { // the directions to half of the neighbours
            const Vec3 way = Vec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1) * lattice.step();
            const Stretch one =
                stretch_through(flow, survey, point, glm::normalize(way), 0.5 * longest);
            if (worth(one) > worth(best) * (1.0 + 1e-9)) {
                best = one;
                velocity = survey.velocity[places[k].second];
            }
        }
    }
    const Vec3 along = best.line[1] - best.line[0];
    if (!(glm::length(along) > 0.0))
        return std::nullopt;
    FluidLine out{best.line, Vec3(0.0), most > 0.0};
    Vec3 across = glm::cross(along, velocity);
    if (!(glm::length(across) > 1e-9 * glm::length(along) * glm::length(velocity)))
        across = glm::cross(along, std::abs(along.x) < std::abs(along.y) ? Vec3(1.0, 0.0, 0.0)
                                                                         : Vec3(0.0, 1.0, 0.0));
    const Vec3 middle = 0.5 * (out.line[0] + out.line[1]);
    const Stretch room =
        stretch_through(flow, survey, middle, glm::normalize(across), sweep * glm::length(along));
    const Vec3 up = room.line[1] - middle;
    const Vec3 down = room.line[0] - middle;
    out.sweep = glm::length(up) >= glm::length(down) ? up : down;
    return out;
}

} // namespace wakesurf::core
