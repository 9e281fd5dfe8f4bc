#include "core/surface/moving/origin.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

/// Of a column's number, found from its seed.
constexpr double rounding = 1e-6;

bool inside(const Origin& origin, const Flow& flow, double s, double t) {
    return flow.status(origin.position(s, t)) == PointStatus::Inside;
}

/// Adds the seeds between two columns of which one is inside and the other is not.
void add_between(std::vector<double>& seeds,
                 const Origin& origin,
                 const Flow& flow,
                 double low,
                 double high,
                 double finest) {
    if (inside(origin, flow, low, 0.0) == inside(origin, flow, high, 0.0) ||
        glm::length(origin.position(high, 0.0) - origin.position(low, 0.0)) <= finest)
        return;
    const double middle = 0.5 * (low + high);
    add_between(seeds, origin, flow, low, middle, finest);
    seeds.push_back(middle);
    add_between(seeds, origin, flow, middle, high, finest);
}

void set_ends(MovingMesh& mesh, const Flow& flow, VertexId v) {
    switch (flow.status(mesh.vertices.position[v])) {
    case PointStatus::Inside:
        break;
    case PointStatus::OutsideDomain:
        mesh.vertices.end[v] = CurveEnd::Domain;
        break;
    case PointStatus::InObstacle:
        mesh.vertices.end[v] = CurveEnd::Obstacle;
        break;
    }
}

} // namespace

double Columns::column(double seed) const {
    const auto after = std::upper_bound(s.begin(), s.end(), seed);
    const auto i =
        std::min(static_cast<std::size_t>(after - s.begin()), static_cast<std::size_t>(count)) - 1;
    const double next = i + 1 < s.size() ? s[i + 1] : 1.0;
    return static_cast<double>(i) + (seed - s[i]) / (next - s[i]);
}

Columns make_columns(const Origin& origin, double intervals) {
    Columns columns;
    columns.closed = origin.closed();
    columns.s = seed_parameters(origin.corners(), intervals);
    columns.count = static_cast<double>(columns.s.size());
    if (!columns.closed)
        columns.s.push_back(1.0);
    return columns;
}

std::vector<double>
row_seeds(const Origin& origin, const Flow& flow, const Columns& columns, double finest) {
    std::vector<double> seeds;
    for (std::size_t i = 0; i < columns.s.size(); ++i) {
        seeds.push_back(columns.s[i]);
        const bool last = i + 1 == columns.s.size();
        if (flow.obstacle() && (!last || columns.closed))
            add_between(seeds, origin, flow, columns.s[i], last ? 1.0 : columns.s[i + 1], finest);
    }
    return seeds;
}

Result<std::vector<VertexId>> attach_row(MovingMesh& mesh,
                                         const Origin& origin,
                                         const Flow& flow,
                                         std::span<const double> seeds,
                                         std::stop_token stop) {
    const std::vector<double> t(seeds.size(), mesh.time);
    const auto points = origin.points(flow, seeds, t, stop);
    if (!points)
        return tl::unexpected(points.error());
    std::vector<VertexId> made;
    for (const MaterialPoint& point : *points) {
        made.push_back(mesh.vertices.add(point, VertexRole::Attached, mesh.time));
        set_ends(mesh, flow, made.back());
    }
    return made;
}

void join_rows(MovingMesh& mesh,
               const Columns& columns,
               std::span<const VertexId> newer,
               std::span<const VertexId> older) {
    const auto& s = mesh.vertices.s;
    std::vector<std::array<VertexId, 4>> quads;
    std::size_t next = 0;
    const auto same_seed = [&](VertexId v) { // seeds ascend in both rows
        while (next < newer.size() && s[newer[next]] < s[v])
            ++next;
        return next < newer.size() && s[newer[next]] == s[v] ? newer[next] : no_vertex;
    };
    const auto join = [&](VertexId new_left, VertexId new_right, VertexId old_left,
                          VertexId old_right) {
        if (new_left != no_vertex && new_right != no_vertex && !mesh.vertices.dead(new_left) &&
            !mesh.vertices.dead(new_right))
            quads.push_back({new_left, new_right, old_right, old_left});
    };
    VertexId left = no_vertex;
    VertexId first = no_vertex;
    for (std::size_t i = 0; i < older.size(); ++i) {
        const VertexId here = same_seed(older[i]);
        if (i == 0)
            first = here;
        else if (columns.column(s[older[i]]) - columns.column(s[older[i - 1]]) <= 1.0 + rounding)
            join(left, here, older[i - 1], older[i]);
        left = here;
    }
    if (columns.closed && older.size() > 2 &&
        columns.column(s[older.back()]) + 1.0 + rounding >=
            columns.count + columns.column(s[older.front()]))
        join(left, first, older.back(), older.front());

    mesh.triangles.append(quads);
}

Result<void> lay_patch(MovingMesh& mesh,
                       const Origin& origin,
                       const Flow& flow,
                       const Columns& columns,
                       double rows,
                       std::stop_token stop) {
    const std::size_t across = columns.s.size();
    {
        std::vector<double> s, t;
        s.reserve(across * static_cast<std::size_t>(rows + 1));
        t.reserve(s.capacity());
        for (double row = 0; row <= rows; ++row)
            for (const double here : columns.s) {
                s.push_back(here);
                t.push_back(row / rows);
            }
        auto points = origin.points(flow, s, t, stop);
        if (!points)
            return tl::unexpected(points.error());
        mesh.vertices.make_room(points->size());
        for (const MaterialPoint& point : *points)
            set_ends(mesh, flow, mesh.vertices.add(point, VertexRole::Free, mesh.time));
    }
    const auto at = [&](std::size_t row, std::size_t column) {
        return static_cast<VertexId>(row * across + column % across);
    };
    // Goes row by row: finding neighbours takes more memory than the triangles among which they are searched.
    std::vector<std::array<VertexId, 4>> quads;
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
        quads.clear();
        for (std::size_t column = 0; column < static_cast<std::size_t>(columns.count); ++column)
            quads.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1),
                             at(row + 1, column)});
        mesh.triangles.append(quads);
    }
    return {};
}

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
