// The exact surface of a request, traced a thousand times as accurately, and the distance of a point from it:
// across it, since a point that has slid along it is drawn on it.
#pragma once

#include "core/surface/moving/origin.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace wakesurf::tests {

class ExactSheet {
  public:
    ExactSheet(const core::Flow& flow, const core::Rake& rake, const core::SurfaceParameters& p)
        : flow_(flow), rake_(rake), seeding_(rake), p_(p) {}

    /// The distance of a point from the particle at (s, t).
    struct Distance {
        double to_particle = 0.0;
        double across = 0.0; ///< from the nearest point of the sheet that is found from there
    };

    /// Returns the distances of some vertices; empty for a particle that ended before, whose exact place is
    /// unknown.
    std::vector<std::optional<Distance>> distances(const core::QuadComplex& mesh,
                                                   const std::vector<core::VertexId>& of) const {
        std::vector<Search> all(of.size());
        for (std::size_t i = 0; i < of.size(); ++i) {
            all[i].drawn = mesh.position[of[i]];
            all[i].s = all[i].tried_s = mesh.s[of[i]];
            all[i].t = all[i].tried_t = mesh.t[of[i]];
        }
        std::vector<std::optional<Distance>> found(of.size());
        for (int round = 0; round < rounds; ++round) {
            std::vector<Search*> active;
            for (Search& each : all)
                if (!each.done)
                    active.push_back(&each);
            look(active);
            for (Search* each : active)
                advance(*each, round == 0);
            if (round == 0)
                for (std::size_t i = 0; i < all.size(); ++i)
                    if (all[i].nearest < std::numeric_limits<double>::max())
                        found[i].emplace().to_particle = all[i].nearest;
        }
        for (std::size_t i = 0; i < all.size(); ++i)
            if (found[i])
                found[i]->across = all[i].across();
        return found;
    }

  private:
    static constexpr int rounds = 6;

    struct Place {
        core::Vec3 position, along_s, along_t;
        bool there = false;
    };

    /// Gauss-Newton with steps that are halved until they come nearer.
    struct Search {
        core::Vec3 drawn;
        double s, t, tried_s, tried_t;
        Place best, tried;
        double nearest = std::numeric_limits<double>::max();
        double step_s = 0.0, step_t = 0.0;
        int halved = 0;
        bool done = false;

        double across() const {
            const core::Vec3 normal = glm::cross(best.along_s, best.along_t);
            const double area = glm::length(normal);
            // Beyond its edge the sheet would continue along its tangents.
            return at_edge && area > 0.0 ? std::abs(glm::dot(drawn - best.position, normal)) / area
                                         : nearest;
        }

        bool at_edge = false;
    };

    void advance(Search& at, bool first) const {
        const double distance = at.tried.there ? glm::length(at.drawn - at.tried.position)
                                               : std::numeric_limits<double>::max();
        if (distance < at.nearest) {
            const bool enough = distance > 0.99 * at.nearest;
            at.best = at.tried;
            at.s = at.tried_s;
            at.t = at.tried_t;
            at.nearest = distance;
            at.halved = 0;
            at.done = enough || distance < 1e-13;
            const core::Vec3 apart = at.drawn - at.best.position;
            const core::Vec3 &a = at.best.along_s, &b = at.best.along_t;
            const double aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b);
            const double det = std::max(aa * bb - ab * ab, 1e-10 * aa * bb);
            if (!(det > 0.0)) {
                at.done = true;
                return;
            }
            at.step_s = (bb * glm::dot(a, apart) - ab * glm::dot(b, apart)) / det;
            at.step_t = (aa * glm::dot(b, apart) - ab * glm::dot(a, apart)) / det;
        } else if (first || ++at.halved > 10) {
            at.done = true;
            return;
        } else {
            at.step_s *= 0.5;
            at.step_t *= 0.5;
        }
        at.tried_s = at.s + at.step_s;
        at.tried_t = at.t + at.step_t;
        const double wanted_s = at.tried_s, wanted_t = at.tried_t;
        at.tried_s =
            rake_.closed() ? at.tried_s - std::floor(at.tried_s) : std::clamp(at.tried_s, 0.0, 1.0);
        const auto [least, most] = range_of_t();
        at.tried_t = std::clamp(at.tried_t, least, most);
        at.at_edge = (!rake_.closed() && wanted_s != at.tried_s) || wanted_t != at.tried_t;
    }

    double tolerance() const { return 1e-3 * core::trace_tolerance(p_.accuracy); }

    std::pair<double, double> range_of_t() const {
        if (p_.kind == core::SurfaceKind::Time)
            return {0.0, 1.0};
        if (p_.kind == core::SurfaceKind::Streak)
            return std::minmax(p_.from, p_.release_until.value_or(p_.to));
        const double span = p_.to - p_.from;
        return std::minmax(p_.direction == core::Direction::Both ? -span : 0.0, span);
    }

    void look(const std::vector<Search*>& all) const {
        if (p_.kind == core::SurfaceKind::Stream || p_.kind == core::SurfaceKind::Path)
            trace(all);
        else
            carry(all);
    }

    void trace(const std::vector<Search*>& all) const {
        for (const double sign : {1.0, -1.0}) {
            std::vector<core::Curve> curves;
            std::vector<Search*> of;
            for (Search* each : all)
                if (sign * each->tried_t > 0.0 || (each->tried_t == 0.0 && sign > 0.0)) {
                    core::Curve& curve = curves.emplace_back();
                    curve.seed = seeding_.at(each->tried_s);
                    curve.seed_tangent = seeding_.tangent(each->tried_s);
                    curve.release = p_.from;
                    curve.duration = each->tried_t == 0.0 ? 1e-300 : each->tried_t;
                    of.push_back(each);
                }
            core::TraceOptions tight{.frozen = p_.kind == core::SurfaceKind::Stream,
                                     .tolerance = tolerance(),
                                     .longest_step = 5.0 * flow_.finest_spacing(),
                                     .stretch = true,
                                     .smooth = p_.interpolation == core::Interpolation::Smooth};
            if (curves.empty() || !flow_.trace(curves, tight, {}))
                continue;
            std::vector<core::Vec3> position, velocity(curves.size());
            std::vector<double> time;
            for (const core::Curve& curve : curves) {
                position.push_back(curve.last.position);
                time.push_back(p_.from + (tight.frozen ? 0.0 : curve.last.time));
            }
            (void)flow_.sample(position, time, velocity, {}, tight.smooth);
            for (std::size_t i = 0; i < of.size(); ++i)
                of[i]->tried = {position[i], curves[i].last.stretch, velocity[i],
                                curves[i].end == core::CurveEnd::Time};
        }
    }

    void carry(const std::vector<Search*>& all) const {
        const core::Origin origin =
            p_.kind == core::SurfaceKind::Streak
                ? core::Origin(seeding_, p_.interpolation == core::Interpolation::Smooth)
            : p_.rake2 ? core::Origin(seeding_, core::SeedingCurve(*p_.rake2), p_.from)
                       : core::Origin(seeding_, *p_.sweep, p_.from);
        std::vector<double> s, t, time;
        for (const Search* each : all) {
            s.push_back(each->tried_s);
            t.push_back(each->tried_t);
            time.push_back(origin.release(each->tried_t));
        }
        const auto born = origin.points(flow_, s, t, {});
        if (all.empty() || !born)
            return;
        std::vector<core::Vec3> position, along_s, along_t;
        for (const core::MaterialPoint& point : *born) {
            position.push_back(point.carried.position);
            along_s.push_back(point.carried.along_s);
            along_t.push_back(point.carried.along_t);
        }
        std::vector<core::CurveEnd> end(all.size(), core::CurveEnd::Running);
        core::AdvanceOptions tight{.method = core::AdvanceOptions::Method::Dopri5,
                                   .tolerance = tolerance(),
                                   .longest_step = 5.0 * flow_.finest_spacing(),
                                   .smooth = p_.interpolation == core::Interpolation::Smooth};
        (void)flow_.advance({position, along_s, along_t, time, end}, p_.to, tight, {});
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i]->tried = {position[i], along_s[i], along_t[i],
                             end[i] == core::CurveEnd::Running};
    }

    const core::Flow& flow_;
    core::Rake rake_;
    core::SeedingCurve seeding_;
    core::SurfaceParameters p_;
};

} // namespace wakesurf::tests
