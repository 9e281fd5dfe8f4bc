#include "core/surface/suggestion/body_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

constexpr int finer = 8; ///< times as many boxes, where an obstacle must be but none was found
constexpr int most_boxes = 3'000'000;
constexpr int closer_look = 16'384; ///< boxes round one body
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
Box closer(const Flow& flow, const Box& rough, const Vec3& margin) {
    const Box domain = flow.domain();
    const Box round{glm::max(domain.lo, rough.lo - margin), glm::min(domain.hi, rough.hi + margin)};
    const SurveyLattice lattice = survey_lattice(round, closer_look);
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

} // namespace wakesurf::core
