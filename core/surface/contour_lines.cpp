#include "core/surface/contour_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace wakesurf::core {

namespace {

using EdgeKey = std::uint64_t; // smaller vertex first

EdgeKey key(VertexId a, VertexId b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

struct Crossing {
    EdgeKey neighbour[2];
    int neighbours = 0;
    bool taken = false;
};

/// A value at a vertex counts as just above it, so that every line crosses sides and never stops at a corner.
bool above(double parameter, double value) {
    return parameter >= value;
}

/// Removes the jumps between the values.
void unwrap(std::span<double> values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (*high - *low <= 0.5)
        return;
    for (double& value : values)
        value += value < 0.5 ? 1.0 : 0.0;
}

class Tracer {
  public:
    Tracer(const QuadComplex& mesh,
           std::span<const double> parameter,
           double value,
           const ContourOptions& options)
        : mesh_(mesh), parameter_(parameter), value_(value), options_(options) {
        for (const Cell& cell : mesh.cells)
            add(cell);
    }

    std::vector<ContourLine> lines() {
        std::vector<ContourLine> found;
        for (const bool ends_only : {true, false})
            for (const EdgeKey edge : order_)
                if (Crossing& at = crossings_.at(edge);
                    !at.taken && (at.neighbours == 1 || !ends_only))
                    if (ContourLine line = follow(edge); line.points.size() > 1)
                        found.push_back(std::move(line));
        return found;
    }

  private:
    void add(const Cell& cell) {
        const CellPolygon outline = polygon(cell);
        const auto values = outline_values(outline, parameter_, options_.wraps);
        std::array<EdgeKey, 8> crossed;
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            const std::uint32_t next = (i + 1) % outline.count;
            if (above(values[i], value_) != above(values[next], value_))
                crossed[count++] = key(outline.vertex[i], outline.vertex[next]);
        }
        for (std::size_t i = 0; i + 1 < count; i += 2) {
            join(crossed[i], crossed[i + 1]);
            join(crossed[i + 1], crossed[i]);
        }
    }

    void join(EdgeKey edge, EdgeKey other) {
        const auto [at, fresh] = crossings_.try_emplace(edge);
        if (fresh)
            order_.push_back(edge);
        if (at->second.neighbours < 2)
            at->second.neighbour[at->second.neighbours++] = other;
    }

    ContourLine follow(EdgeKey start) {
        ContourLine line{value_, crossings_.at(start).neighbours == 2, {}, {}};
        for (EdgeKey edge = start;;) {
            Crossing& here = crossings_.at(edge);
            here.taken = true;
            add_point(line, edge);
            EdgeKey next = edge;
            for (int i = 0; i < here.neighbours; ++i)
                if (!crossings_.at(here.neighbour[i]).taken)
                    next = here.neighbour[i];
            if (next == edge)
                break;
            edge = next;
        }
        if (line.closed && line.points.size() > 1 && line.points.front() == line.points.back())
            pop(line);
        return line;
    }

    void add_point(ContourLine& line, EdgeKey edge) const {
        const auto a = static_cast<VertexId>(edge >> 32);
        const auto b = static_cast<VertexId>(edge);
        std::array<double, 2> ends{parameter_[a], parameter_[b]};
        if (options_.wraps)
            unwrap(ends);
        const double part = (value_ - ends[0]) / (ends[1] - ends[0]);
        const Vec3 point = glm::mix(mesh_.position[a], mesh_.position[b], part);
        if (!line.points.empty() && point == line.points.back())
            return;
        line.points.push_back(point);
        if (!options_.carried.empty())
            line.carried.push_back(std::lerp(options_.carried[a], options_.carried[b], part));
    }

    static void pop(ContourLine& line) {
        line.points.pop_back();
        if (!line.carried.empty())
            line.carried.pop_back();
    }

    const QuadComplex& mesh_;
    std::span<const double> parameter_;
    double value_;
    const ContourOptions& options_;
    std::unordered_map<EdgeKey, Crossing> crossings_; // never iterated
    std::vector<EdgeKey> order_;
};

} // namespace

std::vector<ContourLine> contour_lines(const QuadComplex& mesh,
                                       std::span<const double> parameter,
                                       std::span<const double> values,
                                       const ContourOptions& options) {
    std::vector<ContourLine> all;
    for (const double value : values) {
        std::vector<ContourLine> lines = Tracer(mesh, parameter, value, options).lines();
        std::move(lines.begin(), lines.end(), std::back_inserter(all));
    }
    return all;
}

std::array<double, 8>
outline_values(const CellPolygon& outline, std::span<const double> parameter, bool wraps) {
    std::array<double, 8> values{};
    for (std::uint32_t i = 0; i < outline.count; ++i)
        values[i] = parameter[outline.vertex[i]];
    if (wraps)
        unwrap(std::span(values).first(outline.count));
    return values;
}

std::vector<double>
evenly_spaced(std::span<const double> parameter, std::size_t count, bool wraps) {
    std::vector<double> values;
    if (parameter.empty())
        return values;
    if (wraps) {
        for (std::size_t i = 1; i <= count; ++i)
            values.push_back(static_cast<double>(i) / static_cast<double>(count));
        return values;
    }
    const auto [low, high] = std::minmax_element(parameter.begin(), parameter.end());
    for (std::size_t i = 1; i <= count; ++i)
        values.push_back(*low +
                         (*high - *low) * static_cast<double>(i) / static_cast<double>(count + 1));
    return values;
}

double length_of(const ContourLine& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        sum += glm::length(line.points[i] - line.points[i - 1]);
    return sum;
}

} // namespace wakesurf::core
