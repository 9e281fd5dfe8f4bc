#include "core/surface/even_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace wakesurf::core {

namespace {

/// A parameter's gradient in a cell, by Green's theorem on its outline.
struct Slope {
    Vec3 gradient{0.0}; ///< times the area
    double area = 0.0;
};

Slope slope_of(const QuadComplex& mesh,
               const CellPolygon& outline,
               const std::array<double, 8>& values) {
    Vec3 centre(0.0);
    for (std::uint32_t i = 0; i < outline.count; ++i)
        centre += mesh.position[outline.vertex[i]] / static_cast<double>(outline.count);
    Vec3 twice(0.0);
    for (std::uint32_t i = 0; i < outline.count; ++i)
        twice += glm::cross(mesh.position[outline.vertex[i]] - centre,
                            mesh.position[outline.vertex[(i + 1) % outline.count]] - centre);
    const double length = glm::length(twice);
    if (!(length > 0.0))
        return {};
    const Vec3 normal = twice / length;
    Slope slope{Vec3(0.0), 0.5 * length};
    for (std::uint32_t i = 0; i < outline.count; ++i) {
        const std::uint32_t next = (i + 1) % outline.count;
        const Vec3 side = mesh.position[outline.vertex[next]] - mesh.position[outline.vertex[i]];
        slope.gradient += 0.5 * (values[i] + values[next]) * glm::cross(side, normal);
    }
    return slope;
}

/// A cell's range of the parameter, for levels.
struct CellSpan {
    double low, high; ///< of the parameter, beside each other also across the seam of a closed rake
    double unit;      ///< the longest at a corner
};

std::vector<CellSpan> spans_of(const QuadComplex& mesh,
                               std::span<const double> parameter,
                               std::span<const double> unit,
                               bool wraps) {
    std::vector<CellSpan> spans;
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        const auto values = outline_values(outline, parameter, wraps);
        const auto [low, high] =
            std::minmax_element(values.begin(), values.begin() + outline.count);
        double longest = 0.0;
        for (std::uint32_t i = 0; i < outline.count; ++i)
            if (const double length = unit[outline.vertex[i]]; std::isfinite(length))
                longest = std::max(longest, length);
        spans.push_back({*low, *high, longest});
    }
    return spans;
}

struct CoarsestLevel {
    /// The largest power of two that has a multiple between low and high, apart from 0.
    double power;
    double value; ///< 0 if that is between them, else that multiple
};

std::optional<CoarsestLevel> coarsest_level(double low, double high) {
    const double largest = std::max(std::abs(low), std::abs(high));
    if (!(high > low) || !std::isfinite(largest))
        return std::nullopt;
    // A double has 53 bits: no number is between two that agree in all of them.
    double power = std::exp2(std::ceil(std::log2(largest)));
    for (int k = 0; k < 54; ++k, power *= 0.5) {
        const double above = power * (std::floor(low / power) + 1.0);
        const double value = above == 0.0 ? power : above;
        if (value < high)
            return CoarsestLevel{power, low < 0.0 && high > 0.0 ? 0.0 : value};
    }
    return std::nullopt;
}

/// Pieces of a line where what its points carry is at least `least`.
void keep_pieces(const ContourLine& line,
                 double least,
                 double shortest,
                 std::vector<ContourLine>& out) {
    const auto there = [&](double carried) { return carried >= least; };
    if (std::all_of(line.carried.begin(), line.carried.end(), there)) {
        if (line.closed || length_of(line) >= shortest)
            out.push_back(line);
        return;
    }
    const std::size_t count = line.points.size();
    // A closed line is cut open where it is not there.
    const auto absent = std::find_if_not(line.carried.begin(), line.carried.end(), there);
    const auto first = line.closed ? static_cast<std::size_t>(absent - line.carried.begin()) : 0;
    ContourLine piece{line.value, false, {}, {}};
    const auto finish = [&] {
        if (piece.points.size() > 1 && length_of(piece) >= shortest)
            out.push_back(piece);
        piece.points.clear();
        piece.carried.clear();
    };
    const auto add = [&](const Vec3& point, double carried) {
        if (piece.points.empty() || point != piece.points.back()) {
            piece.points.push_back(point);
            piece.carried.push_back(carried);
        }
    };
    for (std::size_t k = 0; k < count + (line.closed ? 1 : 0); ++k) {
        const std::size_t i = (first + k) % count;
        const double here = line.carried[i];
        if (k > 0) {
            const std::size_t before = (first + k - 1) % count;
            if (there(here) != there(line.carried[before]))
                add(glm::mix(line.points[before], line.points[i],
                             (least - line.carried[before]) / (here - line.carried[before])),
                    least);
        }
        if (there(here))
            add(line.points[i], here);
        else
            finish();
    }
    finish();
}

} // namespace

std::vector<double>
lengths_per_unit(const QuadComplex& mesh, std::span<const double> parameter, bool wraps) {
    std::vector<Slope> sums(mesh.vertices());
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        const Slope slope = slope_of(mesh, outline, outline_values(outline, parameter, wraps));
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            sums[outline.vertex[i]].gradient += slope.gradient;
            sums[outline.vertex[i]].area += slope.area;
        }
    }
    std::vector<double> lengths;
    for (const Slope& sum : sums) {
        const double gradient = glm::length(sum.gradient);
        lengths.push_back(gradient > 0.0 ? sum.area / gradient
                                         : std::numeric_limits<double>::infinity());
    }
    return lengths;
}

Result<std::vector<EvenLevel>> even_levels(const QuadComplex& mesh,
                                           std::span<const double> parameter,
                                           std::span<const double> unit,
                                           double spacing,
                                           bool wraps,
                                           std::size_t most) {
    std::vector<EvenLevel> levels;
    if (parameter.empty())
        return levels;
    const auto [low, high] = std::minmax_element(parameter.begin(), parameter.end());
    const auto coarsest = wraps ? CoarsestLevel{0.5, 0.5} : coarsest_level(*low, *high);
    if (!coarsest)
        return levels;
    const double near =
        spacing / std::numbers::sqrt2; // no closer: the line between two is half-way
    levels.push_back({coarsest->value, 0.0});
    if (wraps)
        levels.push_back({1.0, 2.0 * near});
    const std::vector<CellSpan> spans = spans_of(mesh, parameter, unit, wraps);
    // Half as far apart each time, and only values that a cell has where units are long enough: beside a
    // stagnation line the parameter is a thousand times denser than elsewhere.
    constexpr int finest = 40;
    double apart = coarsest->value == 0.0 ? coarsest->power : 0.5 * coarsest->power;
    bool more = true;
    for (int k = 0; k < finest && more; ++k, apart *= 0.5) {
        more = false;
        const double count = 0.5 / apart; // of one that wraps
        std::vector<double> found;        // values are apart (2 i + 1)
        for (const CellSpan& span : spans) {
            if (!(span.unit * apart >= near))
                continue;
            more = true;
            double i = std::ceil((span.low / apart - 1.0) / 2.0);
            for (; apart * (2.0 * i + 1.0) <= span.high; ++i) {
                if (const double value = apart * (2.0 * i + 1.0); wraps)
                    found.push_back(i - count * std::floor(i / count));
                else if (value > *low && value < *high) // not along a border
                    found.push_back(i);
                if (found.size() > 64 * most) // refused below, once each is counted once
                    break;
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        if (levels.size() + found.size() > most)
            return over_limit(most, "there would be more than " + std::to_string(most) + " lines",
                              "give a larger distance between them");
        for (const double i : found)
            levels.push_back({apart * (2.0 * i + 1.0), near / apart});
    }
    std::sort(levels.begin(), levels.end(),
              [](const EvenLevel& a, const EvenLevel& b) { return a.value < b.value; });
    return levels;
}

std::vector<ContourLine> even_lines(const QuadComplex& mesh,
                                    std::span<const double> parameter,
                                    std::span<const double> unit,
                                    std::span<const EvenLevel> levels,
                                    double spacing,
                                    bool wraps) {
    std::vector<ContourLine> kept;
    for (const EvenLevel& level : levels)
        for (const ContourLine& line :
             contour_lines(mesh, parameter, std::array{level.value}, {wraps, unit}))
            keep_pieces(line, level.least_length, spacing, kept);
    return kept;
}

} // namespace wakesurf::core
