#include "core/surface/suggestion/rake_choice.hpp"

#include "core/surface/suggestion/rake_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace wakesurf::core {

namespace {

// Parts of the body's size: how far ahead of it a rake stands, and how far off its middle (exactly there all
// would end where the flow parts). At a slender body the flow parts along a line, not at a point: further
// off.
constexpr double ahead = 1.0, off_middle = 0.05, off_middle_of_slender = 0.25, slender = 2.0;
/// A part of the way that particles go: the remaining way is for the body and the flow behind it.
constexpr double ahead_of_way = 0.15;
/// A rake reaches beyond a body by so much of its width on each side.
constexpr double beyond = 0.25;
// Parts of the domain's side: a rake's place where the flow enters, its length without a body, its distance
// from the sides.
constexpr double entering = 0.1, usual_length = 0.6, margin = 0.03;
/// A body this wide is as wide as the domain.
constexpr double whole = 0.9;
/// A part of the domain's other side: along a thinner one, as across the slab of a plane flow, a surface is a ribbon
/// that is hardly visible.
constexpr double too_thin = 0.15;
/// A flow whose vorticity changes its velocity by less across the domain does not turn.
constexpr double turning = 0.3;
/// Limits the turns of the fluid where it turns most, while a surface grows; fewer where it moves on at the
/// same time, so that one sees the turns beside each other.
constexpr double most_turns = 4.0, most_turns_through = 2.5;
/// The rake reaches as far beside a vortex as the fluid turns by this part of what it turns there.
constexpr double turns_too = 0.3;
/// A part of the domain's height: where fluid rises less along a vortex within so many turns, a rake across
/// it makes a disc.
constexpr double rises = 0.2;
// Parts of the narrower side across a vortex: how far off its core a rake along it stands, and how far a
// sheet is rolled up round it.
constexpr double off_core = 0.08, rolled = 0.4;
constexpr int line_samples = 64; ///< along a line, for where it is in fluid
constexpr double sweep_of_body = 1.0, sweep_of_domain = 0.25;

double middle(const Box& box, int axis) {
    return 0.5 * (box.lo[axis] + box.hi[axis]);
}

std::array<int, 2> others(int axis) {
    return {(axis + 1) % 3, (axis + 2) % 3};
}

double inside(const Box& domain, int axis, double at) {
    const double gap = margin * domain.extent()[axis];
    return std::clamp(at, domain.lo[axis] + gap, domain.hi[axis] - gap);
}

/// A line along an axis through `at`, as far as it is in fluid; nothing where none of it is.
std::optional<std::array<Vec3, 2>>
line_in_fluid(const Flow& flow, const Vec3& at, int axis, double low, double high) {
    const Box domain = flow.domain();
    low = inside(domain, axis, low);
    high = inside(domain, axis, high);
    const auto place = [&](int i) {
        Vec3 p = at;
        p[axis] = low + (high - low) * i / line_samples;
        return p;
    };
    std::pair<int, int> longest{0, -1};
    for (int i = 0; i <= line_samples; ++i) {
        const int first = i;
        while (i <= line_samples && flow.status(place(i)) == PointStatus::Inside)
            ++i;
        if (i - 1 - first > longest.second - longest.first)
            longest = {first, i - 1};
    }
    if (longest.second - longest.first < line_samples / 8)
        return std::nullopt;
    return std::array{place(longest.first), place(longest.second)};
}

/// The axis out of two along which more of something is; where both have about as much, or the domain is
/// thin, its longer side.
int more_of(const std::array<int, 2>& axes, const Vec3& amount, const Vec3& extent) {
    const auto [a, b] = axes;
    if (std::min(extent[a], extent[b]) < too_thin * std::max(extent[a], extent[b]))
        return extent[a] > extent[b] ? a : b;
    if (std::abs(amount[a] - amount[b]) > 0.05 * std::max(amount[a], amount[b]))
        return amount[a] > amount[b] ? a : b;
    return extent[a] > extent[b] * 1.05 ? a : b;
}

/// Along `axis`, to where there is more room. In a slab not across it, but in its plane.
Vec3 sweep_along(const Box& domain, const Vec3& from, int span, int axis, double length) {
    const Vec3 extent = domain.extent();
    const int third = 3 - span - axis;
    if (extent[axis] < too_thin * std::min(extent[span], extent[third])) {
        length = std::max(length, sweep_of_domain * extent[third]);
        axis = third;
    }
    const double above = domain.hi[axis] - from[axis];
    const double below = from[axis] - domain.lo[axis];
    Vec3 sweep(0.0);
    sweep[axis] = std::min(length, 0.9 * std::max(above, below));
    if (below > above)
        sweep[axis] = -sweep[axis];
    return sweep;
}

/// Returns what of the flow goes along its axis ahead of a body, where that would meet it.
double speed_ahead(const FlowSurvey& survey, const Box& body) {
    const int axis = survey.axis();
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < survey.lattice.size(); ++i) {
        const Vec3 at = survey.lattice.centre(survey.lattice.place(i));
        const bool upstream =
            survey.sign() > 0.0 ? at[axis] < body.lo[axis] : at[axis] > body.hi[axis];
        bool beside = survey.solid[i] == 0 && upstream;
        for (const int k : others(axis)) {
            const double reach = body.extent()[k] + survey.lattice.step()[k];
            beside = beside && std::abs(at[k] - middle(body, k)) < reach;
        }
        if (!beside)
            continue;
        sum += glm::length(survey.velocity[i]);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : glm::length(survey.mean);
}

/// A vortex is fastest round its core.
double fastest_along(const FlowSurvey& survey, const std::array<Vec3, 2>& line) {
    double most = 0.0;
    for (int i = 0; i <= line_samples; ++i) {
        const Vec3 at = line[0] + (line[1] - line[0]) * (double(i) / line_samples);
        const auto box = survey.lattice.index(survey.lattice.box_of(at));
        most = std::max(most, glm::length(survey.velocity[box]));
    }
    return most;
}

/// Speed across a line, in the mean along it: what a rake there sweeps a surface with.
double speed_across(const FlowSurvey& survey, const Vec3& at, int axis, double half) {
    double sum = 0.0;
    for (int i = 0; i <= line_samples; ++i) {
        Vec3 place = at;
        place[axis] =
            inside(survey.lattice.domain, axis, at[axis] + half * (2.0 * i / line_samples - 1.0));
        Vec3 across = survey.velocity[survey.lattice.index(survey.lattice.box_of(place))];
        across[axis] = 0.0;
        sum += glm::length(across);
    }
    return sum / (line_samples + 1);
}

/// Returns a stretch of a line along an axis, widened to where the flow turns too.
std::array<double, 2> where_it_turns(const FlowSurvey& survey,
                                     const Rotation& rotation,
                                     const Vec3& at,
                                     int axis,
                                     std::array<double, 2> stretch) {
    const SurveyLattice& lattice = survey.lattice;
    const double enough = turns_too * glm::length(rotation.vorticity);
    auto box = lattice.box_of(at);
    for (int i = 0; i < lattice.count[static_cast<std::size_t>(axis)]; ++i) {
        box[static_cast<std::size_t>(axis)] = i;
        if (survey.solid[lattice.index(box)] != 0 ||
            glm::length(vorticity_in(survey, box)) < enough)
            continue;
        const double middle = lattice.centre(box)[axis];
        const double half = 0.5 * lattice.step()[axis];
        stretch = {std::min(stretch[0], middle - half), std::max(stretch[1], middle + half)};
    }
    return stretch;
}

/// Returns a rake along a vortex in which the fluid hardly moves on: a sheet from there is rolled up round
/// all of it. Returns nothing where the fluid rises.
std::optional<RakeChoice>
along_vortex(const Flow& flow, const FlowSurvey& survey, const Rotation& rotation, double turn) {
    const Box domain = flow.domain();
    const Vec3 extent = domain.extent();
    const Vec3 direction = glm::abs(rotation.vorticity);
    const int axis =
        static_cast<int>(std::max_element(&direction[0], &direction[0] + 3) - &direction[0]);
    double rising = 0.0;
    for (const Vec3& v : survey.velocity)
        rising += std::abs(v[axis]) / static_cast<double>(survey.velocity.size());
    const auto [a, b] = others(axis);
    const double side = std::min(extent[a], extent[b]);
    if (extent[axis] < too_thin * side || rising * most_turns * turn > rises * extent[axis])
        return std::nullopt;
    const int offset = extent[a] < extent[b] ? b : a;
    RakeChoice choice;
    for (const double sign : {1.0, -1.0}) {
        Vec3 at = rotation.place;
        at[offset] = inside(domain, offset, at[offset] + sign * off_core * side);
        const auto line = line_in_fluid(flow, at, axis, domain.lo[axis], domain.hi[axis]);
        if (!line)
            continue;
        choice.line = *line;
        const double half = 0.5 * glm::length((*line)[1] - (*line)[0]);
        choice.speed = speed_across(survey, 0.5 * ((*line)[0] + (*line)[1]), axis, half);
        if (!(choice.speed > 0.0))
            continue;
        choice.way = std::numbers::pi * rolled * side;
        choice.sweep = sweep_along(domain, at, axis, offset, sweep_of_domain * extent[offset]);
        choice.why =
            "along the place where the flow turns most, which the surface is rolled up round";
        return choice;
    }
    return std::nullopt;
}

/// Returns how far it is along the flow's axis until the domain ends.
double way_out(const FlowSurvey& survey, const Vec3& from) {
    const int axis = survey.axis();
    const Box& domain = survey.lattice.domain;
    const double along =
        survey.sign() > 0.0 ? domain.hi[axis] - from[axis] : from[axis] - domain.lo[axis];
    return along * glm::length(survey.mean) / std::abs(survey.mean[axis]);
}

/// Returns the size of what makes a wake, whatever the body's span.
double size_of(const Box& body, int axis, int span, int offset) {
    const Vec3 extent = body.extent();
    return std::min(extent[span], std::max(extent[offset], extent[axis]));
}

std::optional<RakeChoice> ahead_of_body(const Flow& flow,
                                        const FlowSurvey& survey,
                                        const Box& body,
                                        std::optional<double> time) {
    const Box domain = flow.domain();
    const int axis = survey.axis();
    const auto sides = others(axis);
    const int span = more_of(sides, body.extent(), domain.extent());
    const int offset = span == sides[0] ? sides[1] : sides[0];
    const double size = size_of(body, axis, span, offset);
    RakeChoice choice;
    choice.body = body;
    choice.speed = speed_ahead(survey, body);
    // A body that fills the whole inlet is one that no flow meets.
    if (!(choice.speed > 0.01 * survey.speed))
        return std::nullopt;
    const double front = survey.sign() > 0.0 ? body.lo[axis] : body.hi[axis];
    const double room = survey.sign() > 0.0 ? front - domain.lo[axis] : domain.hi[axis] - front;
    double gap = std::min(ahead * size, 0.6 * room);
    if (time)
        gap = std::min(gap, ahead_of_way * choice.speed * *time);
    const bool wide = body.extent()[span] > whole * domain.extent()[span];
    const double more = beyond * body.extent()[span];
    const bool parts_along_it = wide || body.extent()[span] > slender * body.extent()[offset];
    const double off = parts_along_it && body.extent()[offset] < body.extent()[span]
                           ? off_middle_of_slender
                           : off_middle;
    for (const double part : {1.0, 0.5, 1.5, 0.25}) {
        const double distance = std::min(part * gap, 0.9 * room);
        Vec3 at = 0.5 * (body.lo + body.hi);
        at[axis] = front;
        at -= survey.mean * (distance / std::abs(survey.mean[axis]));
        at[offset] =
            inside(domain, offset, at[offset] + off * std::min(body.extent()[offset], size));
        const auto line =
            wide ? line_in_fluid(flow, at, span, domain.lo[span], domain.hi[span])
                 : line_in_fluid(flow, at, span, body.lo[span] - more, body.hi[span] + more);
        if (!line)
            continue;
        choice.line = *line;
        choice.sweep = sweep_along(domain, at, span, offset, sweep_of_body * size);
        choice.way = way_out(survey, at);
        choice.why = "ahead of a body, across the flow that meets it";
        return choice;
    }
    return std::nullopt;
}

/// Returns a rake through where the flow turns, or a little ahead of it.
std::optional<RakeChoice> at_rotation(const Flow& flow,
                                      const FlowSurvey& survey,
                                      const Rotation& rotation,
                                      std::optional<double> time) {
    const Box domain = flow.domain();
    const Vec3 extent = domain.extent();
    const double turn = 4.0 * std::numbers::pi / std::max(glm::length(rotation.vorticity), 1e-300);
    if (!survey.through())
        if (auto along = along_vortex(flow, survey, rotation, turn))
            return along;
    RakeChoice choice;
    choice.speed = survey.speed;
    Vec3 at = rotation.place;
    int span = 0;
    int offset = 0;
    if (survey.through()) {
        const int axis = survey.axis();
        const auto sides = others(axis);
        span = more_of(sides, glm::abs(rotation.vorticity), extent);
        offset = span == sides[0] ? sides[1] : sides[0];
        const double entry = survey.sign() > 0.0 ? domain.lo[axis] : domain.hi[axis];
        double back = std::abs(at[axis] - entry) - entering * extent[axis];
        if (time)
            back = std::min(back, 2.0 * ahead_of_way * choice.speed * *time);
        at[axis] -= survey.sign() * std::max(0.0, back);
        choice.way = way_out(survey, at);
        choice.why = "across the flow, ahead of where it turns most";
    } else {
        // Across the vortex, and across the way that its middle goes.
        const Vec3 along =
            glm::abs(rotation.vorticity) / std::max(glm::length(rotation.vorticity), 1e-300) +
            glm::abs(rotation.velocity) / std::max(survey.speed, 1e-300);
        std::array<double, 3> across{};
        for (const int k : {0, 1, 2})
            across[static_cast<std::size_t>(k)] =
                speed_across(survey, at, k, 0.5 * usual_length * extent[k]);
        const double least = 0.3 * *std::max_element(across.begin(), across.end());
        const auto crossed = [&](int k) { return across[static_cast<std::size_t>(k)] >= least; };
        for (int k = 1; k < 3; ++k)
            if (crossed(k) && (!crossed(span) || along[k] < along[span] - 0.05 ||
                               (along[k] < along[span] + 0.05 && extent[k] > extent[span])))
                span = k;
        offset = (span + 1) % 3;
        if (along[(span + 2) % 3] > along[offset])
            offset = (span + 2) % 3;
        choice.way = 0.75 * std::max({extent.x, extent.y, extent.z});
        choice.why = "across the place where the flow turns most";
    }
    // Where a sheet is rolled up more often, it is long, and its layers hide each other. In a plane that the flow goes
    // through they lie beside each other.
    const double turns = survey.through() ? most_turns_through : most_turns;
    const Vec3 sides = extent / std::max({extent.x, extent.y, extent.z});
    if (!survey.through() || std::min({sides.x, sides.y, sides.z}) > too_thin * too_thin)
        choice.way = std::min(choice.way, choice.speed * turns * turn);
    const double half = 0.5 * usual_length * extent[span];
    for (const int k : {0, 1, 2})
        at[k] = inside(domain, k, at[k]);
    std::array<double, 2> reach{at[span] - half, at[span] + half};
    if (survey.through())
        reach = where_it_turns(survey, rotation, rotation.place, span, reach);
    const auto line = line_in_fluid(flow, at, span, reach[0], reach[1]);
    if (!line)
        return std::nullopt;
    choice.line = *line;
    choice.sweep = sweep_along(domain, at, span, offset, sweep_of_domain * extent[offset]);
    if (!survey.through())
        choice.speed = std::max(choice.speed, fastest_along(survey, *line));
    return choice;
}

/// Returns a rake in a domain of any shape. Nothing if the survey met no fluid.
std::optional<RakeChoice> through_fluid(const Flow& flow, const FlowSurvey& survey) {
    const Vec3 extent = survey.lattice.domain.extent();
    const double longest = std::max({extent.x, extent.y, extent.z});
    const auto found = find_line(flow, survey, usual_length * longest, sweep_of_domain);
    if (!found)
        return std::nullopt;
    RakeChoice choice;
    choice.line = found->line;
    choice.sweep = found->sweep;
    choice.speed = survey.speed;
    choice.way = 0.75 * longest;
    choice.why = !(survey.speed > 0.0) ? "in the fluid, which is at rest"
                 : found->enters       ? "where the flow enters"
                                       : "where the flow is fastest";
    return choice;
}

/// Returns a rake where more enters than anywhere else: the side of the domain with the fastest flow inward,
/// over its boxes. Nothing where that side is no plain inlet.
std::optional<RakeChoice> at_entry(const Flow& flow, const FlowSurvey& survey) {
    const SurveyLattice& lattice = survey.lattice;
    const Box& domain = lattice.domain;
    const Vec3 extent = domain.extent();
    double most = -1.0;
    int axis = 0;
    bool low = true;
    for (std::size_t k = 0; k < 3; ++k)
        for (const bool at_low : {true, false}) {
            double inward = 0.0;
            double boxes = 0.0;
            for (std::size_t i = 0; i < lattice.size(); ++i) {
                if (lattice.place(i)[k] != (at_low ? 0 : lattice.count[k] - 1))
                    continue;
                const double along = survey.velocity[i][static_cast<int>(k)];
                inward += std::max(0.0, at_low ? along : -along);
                boxes += 1.0;
            }
            if (boxes > 0.0 && inward / boxes > most * (1.0 + 1e-9)) {
                most = inward / boxes;
                axis = static_cast<int>(k);
                low = at_low;
            }
        }
    RakeChoice choice;
    choice.speed = survey.speed;
    const auto sides = others(axis);
    const int span = more_of(sides, extent, extent);
    const int offset = span == sides[0] ? sides[1] : sides[0];
    Vec3 at = domain.lo + 0.5 * extent;
    at[axis] =
        low ? domain.lo[axis] + entering * extent[axis] : domain.hi[axis] - entering * extent[axis];
    at[offset] += margin * extent[offset];
    const double half = 0.5 * usual_length * extent[span];
    const auto line = line_in_fluid(flow, at, span, at[span] - half, at[span] + half);
    if (!line || glm::length((*line)[1] - (*line)[0]) < half)
        return std::nullopt;
    choice.line = *line;
    choice.sweep = sweep_along(domain, at, span, offset, sweep_of_domain * extent[offset]);
    // Fluid that enters and does not go through turns aside half-way.
    choice.way = (survey.through() ? 1.0 : 0.5) * extent[axis];
    choice.why = survey.speed > 0.0 ? "where the flow enters"
                                    : "near a side of the domain, because the flow is at rest";
    return choice;
}

} // namespace

RakeChoice choose_rake(const Flow& flow,
                       const FlowSurvey& survey,
                       const WallGeometry& walls,
                       std::optional<double> time) {
    if (survey.through()) {
        if (const auto body = find_body(flow, survey, walls))
            if (auto choice = ahead_of_body(flow, survey, *body, time))
                return *choice;
    }
    const Rotation rotation = strongest_rotation(survey);
    if (rotation.strength > turning)
        if (auto choice = at_rotation(flow, survey, rotation, time))
            return *choice;
    if (const auto choice = at_entry(flow, survey))
        return *choice;
    if (const auto choice = through_fluid(flow, survey))
        return *choice;
    RakeChoice across;
    const Box domain = flow.domain();
    across.line = {domain.lo, domain.hi};
    across.why = "across the whole domain, because no fluid was found in it";
    return across;
}

} // namespace wakesurf::core
