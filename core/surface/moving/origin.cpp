#include "core/surface/moving/origin.hpp"

#include <algorithm>

namespace wakesurf::core {

Origin::Origin(SeedingCurve rake, bool smooth) : curve_(std::move(rake)), smooth_(smooth) {}

Origin::Origin(SeedingCurve rake, SeedingCurve opposite, double release)
    : curve_(std::move(rake)), opposite_(std::move(opposite)), release_(release) {}

Origin::Origin(SeedingCurve rake, const Vec3& sweep, double release)
    : curve_(std::move(rake)), sweep_(sweep), release_(release) {}

bool Origin::closed() const {
    return curve_.closed() && (!opposite_ || opposite_->closed());
}

Vec3 Origin::position(double s, double t) const {
    const Vec3 near = curve_.at(s);
    if (opposite_)
        return glm::mix(near, opposite_->at(s), t);
    return sweep_ ? near + t * *sweep_ : near;
}

double Origin::longest_across() const {
    double longest = 0.0;
    for (int i = 0; i <= 16; ++i)
        longest = std::max(longest, glm::length(position(i / 16.0, 1.0) - position(i / 16.0, 0.0)));
    return longest;
}

double Origin::length() const {
    return opposite_ ? std::max(curve_.length(), opposite_->length()) : curve_.length();
}

std::vector<double> Origin::corners() const {
    std::vector<double> all = curve_.corners();
    if (opposite_) {
        const std::vector<double> others = opposite_->corners();
        all.insert(all.end(), others.begin(), others.end());
        std::sort(all.begin(), all.end());
    }
    return all;
}

Result<std::vector<MaterialPoint>> Origin::points(const Flow& flow,
                                                  std::span<const double> s,
                                                  std::span<const double> t,
                                                  std::stop_token stop) const {
    std::vector<MaterialPoint> points(s.size());
    std::vector<Vec3> positions(s.size()), velocities(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
        positions[i] = position(s[i], t[i]);
        points[i].carried.position = positions[i];
        points[i].carried.along_s = curve_.tangent(s[i]);
        if (opposite_) {
            points[i].carried.along_s =
                glm::mix(points[i].carried.along_s, opposite_->tangent(s[i]), t[i]);
            points[i].carried.along_t = opposite_->at(s[i]) - curve_.at(s[i]);
        } else if (sweep_) {
            points[i].carried.along_t = *sweep_;
        }
        points[i].s = s[i];
        points[i].t = t[i];
    }
    if (!patch()) {
        if (auto sampled = flow.sample(positions, t, velocities, stop, smooth_); !sampled)
            return tl::unexpected(sampled.error());
        for (std::size_t i = 0; i < s.size(); ++i)
            points[i].carried.along_t = -velocities[i];
    }
    for (MaterialPoint& point : points)
        point.birth_area = static_cast<float>(
            glm::length(glm::cross(point.carried.along_s, point.carried.along_t)));
    return points;
}

Result<void> retrace(MovingMesh& mesh,
                     const Origin& origin,
                     const Flow& flow,
                     std::span<const VertexId> vertices,
                     AdvanceOptions options,
                     std::stop_token stop) {
    std::vector<double> s, t, time;
    for (const VertexId v : vertices) {
        s.push_back(mesh.vertices.s[v]);
        t.push_back(mesh.vertices.t[v]);
        time.push_back(origin.release(t.back()));
    }
    const auto born = origin.points(flow, s, t, stop);
    if (!born)
        return tl::unexpected(born.error());
    std::vector<Vec3> position, along_s, along_t;
    std::vector<float> expansion(vertices.size(), 0.0f);
    std::vector<CurveEnd> end(vertices.size(), CurveEnd::Running);
    for (const MaterialPoint& point : *born) {
        position.push_back(point.carried.position);
        along_s.push_back(point.carried.along_s);
        along_t.push_back(point.carried.along_t);
        if (flow.status(point.carried.position) != PointStatus::Inside)
            end[position.size() - 1] = CurveEnd::Obstacle;
    }
    options.method = AdvanceOptions::Method::Dopri5;
    if (auto advanced = flow.advance({position, along_s, along_t, time, end, {}, {}, {}, expansion},
                                     mesh.time, options, stop);
        !advanced)
        return tl::unexpected(advanced.error());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const VertexId v = vertices[i];
        MaterialPoint point = (*born)[i];
        point.carried = {position[i], along_s[i], along_t[i], double(expansion[i])};
        point.place = mesh.vertices.place[v];
        const double way = glm::length(position[i] - (*born)[i].carried.position);
        point.error.traced = mesh.vertices.error[v].traced;
        point.error.traced.add(tangents_of(point.carried), options.tolerance * way);
        point.error.apart.add(tangents_of(point.carried), options.tolerance * way);
        mesh.vertices.set(v, point);
        mesh.vertices.time[v] = time[i];
        mesh.vertices.end[v] = end[i];
    }
    return {};
}

} // namespace wakesurf::core
