#include "core/surface/contour_lines.hpp"

#include <algorithm>
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

Vec3 place(const QuadComplex& mesh, std::span<const double> parameter, EdgeKey edge, double value) {
    const auto a = static_cast<VertexId>(edge >> 32);
    const auto b = static_cast<VertexId>(edge);
    return glm::mix(mesh.position[a], mesh.position[b],
                    (value - parameter[a]) / (parameter[b] - parameter[a]));
}

class Tracer {
  public:
    Tracer(const QuadComplex& mesh, std::span<const double> parameter, double value)
        : mesh_(mesh), parameter_(parameter), value_(value) {
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
        std::array<EdgeKey, 8> crossed;
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            const VertexId a = outline.vertex[i];
            const VertexId b = outline.vertex[(i + 1) % outline.count];
            if (above(parameter_[a], value_) != above(parameter_[b], value_))
                crossed[count++] = key(a, b);
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
        ContourLine line{value_, crossings_.at(start).neighbours == 2, {}};
        for (EdgeKey edge = start;;) {
            Crossing& here = crossings_.at(edge);
            here.taken = true;
            const Vec3 point = place(mesh_, parameter_, edge, value_);
            if (line.points.empty() || point != line.points.back())
                line.points.push_back(point);
            EdgeKey next = edge;
            for (int i = 0; i < here.neighbours; ++i)
                if (!crossings_.at(here.neighbour[i]).taken)
                    next = here.neighbour[i];
            if (next == edge)
                break;
            edge = next;
        }
        if (line.closed && line.points.size() > 1 && line.points.front() == line.points.back())
            line.points.pop_back();
        return line;
    }

    const QuadComplex& mesh_;
    std::span<const double> parameter_;
    double value_;
    std::unordered_map<EdgeKey, Crossing> crossings_; // looked up only
    std::vector<EdgeKey> order_;
};

} // namespace

std::vector<ContourLine> contour_lines(const QuadComplex& mesh,
                                       std::span<const double> parameter,
                                       std::span<const double> values) {
    std::vector<ContourLine> all;
    for (const double value : values) {
        std::vector<ContourLine> lines = Tracer(mesh, parameter, value).lines();
        std::move(lines.begin(), lines.end(), std::back_inserter(all));
    }
    return all;
}

std::vector<double> evenly_spaced(std::span<const double> parameter, std::size_t count) {
    std::vector<double> values;
    if (parameter.empty())
        return values;
    const auto [low, high] = std::minmax_element(parameter.begin(), parameter.end());
    for (std::size_t i = 1; i <= count; ++i)
        values.push_back(*low +
                         (*high - *low) * static_cast<double>(i) / static_cast<double>(count + 1));
    return values;
}

} // namespace wakesurf::core
