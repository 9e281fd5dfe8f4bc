#include "core/surface/suggestion/rake_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace wakesurf::core {

namespace {

constexpr int finer = 8; ///< times as many boxes, where an obstacle must be but none was found
constexpr int most_boxes = 3'000'000;
constexpr int boxes_round_body = 16'384; ///< boxes round one body
constexpr double flat = 1e-3; ///< of a side: how near to a side of the domain a wall is that side
constexpr std::size_t most_triangles = 400'000; ///< of the tested walls, evenly chosen
constexpr int most_cuts = 256;  ///< a triangle's sides are cut into, to reach every box it crosses
constexpr double similar = 0.5; ///< as large as the largest, about

Box nothing() {
    return {Vec3(std::numeric_limits<double>::infinity()),
            Vec3(-std::numeric_limits<double>::infinity())};
}

void extend(Box& box, const Vec3& point) {
    box.lo = glm::min(box.lo, point);
    box.hi = glm::max(box.hi, point);
}

/// Lies in one of the domain's own sides.
bool on_a_side(const std::array<Vec3, 3>& corner, const Box& domain) {
    const Vec3 near = flat * domain.extent();
    for (int k = 0; k < 3; ++k) {
        const auto all = [&](double side) {
            return std::ranges::all_of(
                corner, [&](const Vec3& p) { return std::abs(p[k] - side) <= near[k]; });
        };
        if (all(domain.lo[k]) || all(domain.hi[k]))
            return true;
    }
    return false;
}

/// Boxes that are not fluid or that a wall crosses, and where exactly the wall is.
struct Marks {
    std::vector<std::uint8_t> marked;
    std::vector<Box> wall; ///< in each box; empty boxes where there is none
};

void mark_walls(Marks& marks, const SurveyLattice& lattice, const WallGeometry& walls) {
    const std::size_t stride = walls.triangles.size() / most_triangles + 1;
    const Vec3 step = lattice.step();
    for (std::size_t t = 0; t < walls.triangles.size(); t += stride) {
        std::array<Vec3, 3> corner{};
        for (std::size_t k = 0; k < 3; ++k)
            corner[k] = Vec3(walls.points[walls.triangles[t][k]]);
        if (on_a_side(corner, lattice.domain))
            continue;
        const Vec3 reach = (glm::max(corner[0], glm::max(corner[1], corner[2])) -
                            glm::min(corner[0], glm::min(corner[1], corner[2]))) /
                           glm::max(step, Vec3(1e-300));
        const int cuts = std::clamp(
            static_cast<int>(std::ceil(std::max({reach.x, reach.y, reach.z}))), 1, most_cuts);
        for (int i = 0; i <= cuts; ++i)
            for (int j = 0; i + j <= cuts; ++j) {
                const Vec3 point = (corner[0] * double(i) + corner[1] * double(j) +
                                    corner[2] * double(cuts - i - j)) /
                                   double(cuts);
                const std::size_t at = lattice.index(lattice.box_of(point));
                marks.marked[at] = 1;
                extend(marks.wall[at], point);
            }
    }
}

/// Returns groups of boxes that touch, even at a corner alone. It empties `marked`.
std::vector<std::vector<std::size_t>> groups(const SurveyLattice& lattice,
                                             std::vector<std::uint8_t>& marked) {
    std::vector<std::vector<std::size_t>> out;
    for (std::size_t first = 0; first < marked.size(); ++first) {
        if (marked[first] == 0)
            continue;
        std::vector<std::size_t>& group = out.emplace_back(1, first);
        marked[first] = 0;
        for (std::size_t next = 0; next < group.size(); ++next) {
            const auto at = lattice.place(group[next]);
            for (int n = 0; n < 27; ++n) {
                const std::array<int, 3> to{at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1,
                                            at[2] + n / 9 - 1};
                bool there = true;
                for (std::size_t k = 0; k < 3; ++k)
                    there = there && to[k] >= 0 && to[k] < lattice.count[k];
                if (!there || marked[lattice.index(to)] == 0)
                    continue;
                marked[lattice.index(to)] = 0;
                group.push_back(lattice.index(to));
            }
        }
    }
    return out;
}

/// A body's own extent, to a fraction of the boxes it was found with.
Box closer(const Flow& flow, const Box& rough, const Vec3& around) {
    const Box domain = flow.domain();
    const Box round{glm::max(domain.lo, rough.lo - around), glm::min(domain.hi, rough.hi + around)};
    const SurveyLattice lattice = survey_lattice(round, boxes_round_body);
    const auto solid = not_fluid(flow, lattice);
    Box out = nothing();
    for (std::size_t i = 0; i < solid.size(); ++i)
        if (solid[i] != 0) {
            const Vec3 centre = lattice.centre(lattice.place(i));
            extend(out, centre - 0.5 * lattice.step());
            extend(out, centre + 0.5 * lattice.step());
        }
    return out.lo.x > out.hi.x ? rough : out;
}

struct Body {
    Box box;
    bool at_wall; ///< the box is that of its wall; else of the lattice's boxes
};

Body body_of(const SurveyLattice& lattice,
             const std::vector<std::size_t>& group,
             const Marks& marks) {
    Box wall = nothing();
    Box rough = nothing();
    for (const std::size_t i : group) {
        const Vec3 centre = lattice.centre(lattice.place(i));
        extend(rough, centre - 0.5 * lattice.step());
        extend(rough, centre + 0.5 * lattice.step());
        if (marks.wall[i].lo.x <= marks.wall[i].hi.x) {
            extend(wall, marks.wall[i].lo);
            extend(wall, marks.wall[i].hi);
        }
    }
    const bool at_wall = wall.lo.x <= wall.hi.x;
    return {at_wall ? wall : rough, at_wall};
}

std::vector<Body> bodies_on(const SurveyLattice& lattice,
                            std::vector<std::uint8_t> solid,
                            std::size_t axis,
                            const WallGeometry& walls) {
    Marks marks{std::move(solid), std::vector<Box>(lattice.size(), nothing())};
    mark_walls(marks, lattice, walls);
    std::vector<Body> bodies;
    for (const auto& group : groups(lattice, marks.marked)) {
        const bool at_an_end = std::ranges::any_of(group, [&](std::size_t i) {
            const int along = lattice.place(i)[axis];
            return along == 0 || along == lattice.count[axis] - 1;
        });
        if (!at_an_end)
            bodies.push_back(body_of(lattice, group, marks));
    }
    return bodies;
}

double across(const Box& body, int axis) {
    const Vec3 extent = body.extent();
    return extent[(axis + 1) % 3] * extent[(axis + 2) % 3];
}

/// Returns, of the largest across the flow, the one that the flow meets first. REQUIRES: there is one.
const Body& first_of(const std::vector<Body>& bodies, const FlowSurvey& survey) {
    const int axis = survey.axis();
    double largest = 0.0;
    for (const Body& body : bodies)
        largest = std::max(largest, across(body.box, axis));
    const auto front = [&](const Body& body) {
        return survey.sign() > 0.0 ? body.box.lo[axis] : -body.box.hi[axis];
    };
    const Body* best = nullptr;
    for (const Body& body : bodies)
        if (across(body.box, axis) >= similar * largest && (!best || front(body) < front(*best)))
            best = &body;
    return *best;
}

} // namespace

std::optional<Box>
find_body(const Flow& flow, const FlowSurvey& survey, const WallGeometry& walls) {
    const auto axis = static_cast<std::size_t>(survey.axis());
    SurveyLattice lattice = survey.lattice;
    auto bodies = bodies_on(lattice, survey.solid, axis, walls);
    if (bodies.empty() && flow.obstacle() && walls.triangles.empty())
        for (int boxes = finer * static_cast<int>(lattice.size());
             bodies.empty() && boxes < most_boxes; boxes *= finer) {
            lattice = survey_lattice(flow.domain(), boxes);
            bodies = bodies_on(lattice, not_fluid(flow, lattice), axis, walls);
        }
    if (bodies.empty())
        return std::nullopt;
    const Body& first = first_of(bodies, survey);
    // Only this body is examined more closely: a mesh with holes everywhere has hundreds.
    return first.at_wall ? first.box : closer(flow, first.box, lattice.step());
}

namespace {

constexpr int line_steps = 64; ///< along a line, for where it is in fluid
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
    const Vec3 step = direction * (2.0 * half / line_steps);
    Stretch out{{point, point}, 0.0};
    for (const double sign : {-1.0, 1.0}) {
        Vec3& end = out.line[sign < 0.0 ? 0 : 1];
        for (int i = 0; i < line_steps / 2; ++i) {
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
