#include "core/surface/lines/wall_web.hpp"

#include "core/surface/lines/line_seeds.hpp"
#include "core/surface/same_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

/// Of the square of the longest side: what has a smaller area has no direction.
constexpr double least_area = 1e-10;

struct EdgeOf {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t triangle_and_corner;

    auto operator<=>(const EdgeOf&) const = default;
};

} // namespace

Vec3 WallWeb::Beyond::place(double u) const {
    Vec3 out(0.0);
    out[first] = 1.0 - u;
    out[second] = u;
    return out;
}

WallWeb::WallWeb(const WallFlow& flow, double stagnation)
    : position_(flow.wall.position), triangles_(wall_triangles(flow.wall)) {
    const std::vector<std::uint32_t> first = same_places(position_);
    for (auto& triangle : triangles_)
        for (VertexId& vertex : triangle)
            vertex = first[vertex];
    velocity_.assign(position_.size(), Vec3(0.0));
    value_.assign(position_.size(), 0.0F);
    std::vector<std::uint32_t> known(position_.size(), 0);
    std::vector<std::uint32_t> valued(position_.size(), 0);
    for (std::size_t v = 0; v < position_.size(); ++v) { // the mean of all at a place
        if (const Vec3 velocity(flow.velocity[v]); finite(velocity)) {
            velocity_[first[v]] += velocity;
            ++known[first[v]];
        }
        if (std::isfinite(flow.values[v])) {
            value_[first[v]] += flow.values[v];
            ++valued[first[v]];
        }
    }
    for (std::size_t v = 0; v < position_.size(); ++v) {
        // None of none is no number.
        velocity_[v] /= static_cast<double>(known[v]);
        value_[v] = valued[v] > 0 ? value_[v] / static_cast<float>(valued[v])
                                  : std::numeric_limits<float>::quiet_NaN();
    }
    lay_into_wall();
    for (const Vec3& each : velocity_)
        if (finite(each))
            rest_ = std::max(rest_, stagnation * glm::length(each));
    join();
}

void WallWeb::lay_into_wall() {
    std::vector<Vec3> normal(position_.size(), Vec3(0.0));
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        const Vec3 across = glm::cross(edge(t, 2), edge(t, 0));
        if (!finite(across))
            continue;
        for (const VertexId vertex : triangles_[t]) // triangles are turned as their source has them
            normal[vertex] += glm::dot(normal[vertex], across) < 0.0 ? -across : across;
    }
    for (std::size_t v = 0; v < normal.size(); ++v)
        if (const double square = glm::dot(normal[v], normal[v]); square > 0.0)
            velocity_[v] -= glm::dot(velocity_[v], normal[v]) / square * normal[v];
}

void WallWeb::join() {
    const std::size_t count = triangles_.size();
    beyond_.assign(count, {none, none, none});
    around_begin_.assign(position_.size() + 1, 0);
    std::vector<EdgeOf> edges;
    edges.reserve(3 * count);
    for (std::uint32_t t = 0; t < count; ++t) {
        if (!gradients(t))
            continue;
        for (std::uint32_t c = 0; c < 3; ++c) {
            const auto [low, high] =
                std::minmax(triangles_[t][(c + 1) % 3], triangles_[t][(c + 2) % 3]);
            edges.push_back({{low, high}, 3 * t + c});
            ++around_begin_[triangles_[t][c] + 1];
        }
    }
    std::ranges::sort(edges);
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        while (end < edges.size() && edges[end].ends == edges[begin].ends)
            ++end;
        if (end - begin != 2)
            continue;
        const std::uint32_t a = edges[begin].triangle_and_corner;
        const std::uint32_t b = edges[begin + 1].triangle_and_corner;
        beyond_[a / 3][a % 3] = b;
        beyond_[b / 3][b % 3] = a;
    }
    for (std::size_t v = 0; v < position_.size(); ++v)
        around_begin_[v + 1] += around_begin_[v];
    around_.resize(around_begin_.back());
    std::vector<std::uint32_t> next(around_begin_.begin(), around_begin_.end() - 1);
    for (std::uint32_t t = 0; t < count; ++t)
        if (gradients(t))
            for (int c = 0; c < 3; ++c)
                around_[next[triangles_[t][static_cast<std::size_t>(c)]]++] = {t, c};
}

std::size_t WallWeb::bytes(const QuadComplex& wall) {
    constexpr std::size_t vertex = sizeof(Vec3) * 2 + sizeof(float) + 6 * sizeof(std::uint32_t);
    constexpr std::size_t triangle =
        6 * sizeof(std::uint32_t) + 3 * (sizeof(EdgeOf) + sizeof(Corner));
    return wall.vertices() * vertex + 2 * wall.cells.size() * triangle;
}

/// Returns how each part changes from place to place.
std::optional<std::array<Vec3, 3>> WallWeb::gradients(std::uint32_t triangle) const {
    const Vec3 across = glm::cross(edge(triangle, 2), edge(triangle, 0));
    const double square = glm::dot(across, across);
    double longest = 0.0;
    for (int c = 0; c < 3; ++c)
        longest = std::max(longest, glm::dot(edge(triangle, c), edge(triangle, c)));
    if (!(std::sqrt(square) > least_area * longest) || !std::isfinite(square))
        return std::nullopt;
    std::array<Vec3, 3> out;
    for (int c = 0; c < 3; ++c)
        out[static_cast<std::size_t>(c)] = glm::cross(across, edge(triangle, c)) / square;
    return out;
}

std::optional<WallWeb::Rates> WallWeb::rates(std::uint32_t triangle) const {
    const auto gradient = gradients(triangle);
    if (!gradient)
        return std::nullopt;
    Rates out;
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 3; ++i)
            out[c][i] = glm::dot((*gradient)[static_cast<std::size_t>(i)], velocity(triangle, c));
    for (int c = 0; c < 3; ++c)
        if (!finite(out[c]))
            return std::nullopt;
    return out;
}

Vec3 WallWeb::corner(std::uint32_t triangle, int corner) const {
    return position_[triangles_[triangle][static_cast<std::size_t>(corner)]];
}

Vec3 WallWeb::velocity(std::uint32_t triangle, int corner) const {
    return velocity_[triangles_[triangle][static_cast<std::size_t>(corner)]];
}

Vec3 WallWeb::edge(std::uint32_t triangle, int opposite) const {
    return corner(triangle, (opposite + 2) % 3) - corner(triangle, (opposite + 1) % 3);
}

Vec3 WallWeb::way(std::uint32_t triangle, const Vec3& rate) const {
    return rate.x * corner(triangle, 0) + rate.y * corner(triangle, 1) +
           rate.z * corner(triangle, 2);
}

float WallWeb::value(std::uint32_t triangle, const Vec3& parts) const {
    const auto& [a, b, c] = triangles_[triangle];
    return static_cast<float>(parts.x * value_[a] + parts.y * value_[b] + parts.z * value_[c]);
}

Vec3 WallWeb::parts(std::uint32_t triangle, const Vec3& place) const {
    const auto gradient = gradients(triangle);
    if (!gradient)
        return Vec3(1.0 / 3.0);
    Vec3 out;
    for (int c = 0; c < 3; ++c)
        out[c] = std::max(0.0, glm::dot((*gradient)[static_cast<std::size_t>(c)],
                                        place - corner(triangle, (c + 1) % 3)));
    return out / (out.x + out.y + out.z);
}

std::optional<WallWeb::Beyond> WallWeb::beyond(std::uint32_t triangle, int opposite) const {
    const std::uint32_t other = beyond_[triangle][static_cast<std::size_t>(opposite)];
    if (other == none)
        return std::nullopt;
    Beyond out{other / 3, static_cast<int>(other % 3), 0, 0};
    const VertexId first = triangles_[triangle][static_cast<std::size_t>((opposite + 1) % 3)];
    const int next = (out.opposite + 1) % 3;
    const int after = (out.opposite + 2) % 3;
    const bool turned = triangles_[out.triangle][static_cast<std::size_t>(next)] != first;
    out.first = turned ? after : next;
    out.second = turned ? next : after;
    return out;
}

std::span<const WallWeb::Corner> WallWeb::around(std::uint32_t triangle, int corner) const {
    const VertexId vertex = triangles_[triangle][static_cast<std::size_t>(corner)];
    return std::span(around_).subspan(around_begin_[vertex],
                                      around_begin_[vertex + 1] - around_begin_[vertex]);
}

} // namespace wakesurf::core
