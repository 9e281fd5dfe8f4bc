#include "core/surface/moving/first_row.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

bool inside(const Origin& origin, const Flow& flow, double s, double t) {
    return flow.status(origin.position(s, t)) == PointStatus::Inside;
}

/// Adds the places between two columns of which one is inside and the other is not.
void add_between(std::vector<double>& places,
                 const Origin& origin,
                 const Flow& flow,
                 const Columns& columns,
                 double low,
                 double high,
                 double finest) {
    const double s_low = columns.at(low);
    const double s_high = columns.at(high);
    if (inside(origin, flow, s_low, 0.0) == inside(origin, flow, s_high, 0.0) ||
        glm::length(origin.position(s_high, 0.0) - origin.position(s_low, 0.0)) <= finest)
        return;
    const double middle = 0.5 * (low + high);
    add_between(places, origin, flow, columns, low, middle, finest);
    places.push_back(middle);
    add_between(places, origin, flow, columns, middle, high, finest);
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

double Columns::at(double column) const {
    const double floor = std::min(std::floor(column), count - 1.0);
    const auto i = static_cast<std::size_t>(floor);
    const double next = i + 1 < s.size() ? s[i + 1] : 1.0;
    return s[i] + (column - floor) * (next - s[i]);
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
seed_places(const Origin& origin, const Flow& flow, const Columns& columns, double finest) {
    std::vector<double> places;
    for (double column = 0; column < static_cast<double>(columns.s.size()); ++column) {
        places.push_back(column);
        if (column + 1.0 <= columns.count && flow.obstacle() &&
            (columns.closed || column + 1.0 < static_cast<double>(columns.s.size())))
            add_between(places, origin, flow, columns, column, column + 1.0, finest);
    }
    return places;
}

Result<std::vector<VertexId>> attach_row(MovingMesh& mesh,
                                         const Origin& origin,
                                         const Flow& flow,
                                         const Columns& columns,
                                         std::span<const double> places,
                                         double row,
                                         std::stop_token stop) {
    std::vector<double> s, t(places.size(), mesh.time);
    for (const double place : places)
        s.push_back(columns.at(place));
    auto points = origin.points(flow, s, t, stop);
    if (!points)
        return tl::unexpected(points.error());
    std::vector<VertexId> made;
    for (std::size_t i = 0; i < places.size(); ++i) {
        (*points)[i].place = {places[i], row};
        made.push_back(mesh.vertices.add((*points)[i], VertexRole::Attached, mesh.time));
        set_ends(mesh, flow, made.back());
    }
    return made;
}

void join_rows(MovingMesh& mesh, std::span<const VertexId> newer, std::span<const VertexId> older) {
    const auto& place = mesh.vertices.place;
    std::vector<std::array<VertexId, 4>> quads;
    std::size_t next = 0;
    const auto same_place = [&](VertexId v) { // places ascend in both rows
        while (next < newer.size() && place[newer[next]].column < place[v].column)
            ++next;
        return next < newer.size() && place[newer[next]].column == place[v].column ? newer[next]
                                                                                   : no_vertex;
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
        const VertexId here = same_place(older[i]);
        if (i == 0)
            first = here;
        else if (place[older[i]].column - place[older[i - 1]].column <= 1.0)
            join(left, here, older[i - 1], older[i]);
        left = here;
    }
    if (mesh.lattice.closed && older.size() > 2 &&
        place[older.back()].column + 1.0 >= mesh.lattice.columns + place[older.front()].column)
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
        for (std::size_t i = 0; i < points->size(); ++i) {
            (*points)[i].place = {static_cast<double>(i % across), static_cast<double>(i / across)};
            set_ends(mesh, flow, mesh.vertices.add((*points)[i], VertexRole::Free, mesh.time));
        }
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

} // namespace wakesurf::core
