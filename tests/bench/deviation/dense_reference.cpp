#include "tests/bench/deviation/dense_reference.hpp"

#include "tests/bench/deviation/to_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace wakesurf::bench {

using core::Vec3;

namespace {

constexpr double spacing = 0.25;     ///< cells between vertices of a column
constexpr double widest = 1.0 / 3.0; ///< cells between columns
constexpr double narrowest = 1e-6;   ///< between seeds: there the surface tears

/// Traces again, longer, until every curve has gone far enough or has ended.
void trace_far_enough(const core::Flow& flow, std::span<core::Curve> curves, double arc) {
    core::TraceOptions options;
    options.frozen = true;
    options.tolerance = 1e-11;
    options.longest_step = flow.finest_spacing();
    options.most_steps = 10'000'000;
    for (std::size_t unfinished = curves.size(); unfinished > 0;) {
        if (!flow.trace(curves.first(unfinished), options, {}))
            throw std::runtime_error("the reference's columns cannot be traced");
        const auto finished = [&](const core::Curve& c) {
            return c.end != core::CurveEnd::Time || c.last.arc >= arc;
        };
        const auto done =
            std::partition(curves.begin(), curves.begin() + static_cast<std::ptrdiff_t>(unfinished),
                           [&](const core::Curve& c) { return !finished(c); });
        unfinished = static_cast<std::size_t>(done - curves.begin());
        for (core::Curve& c : curves.first(unfinished)) {
            const double longer = std::clamp(1.1 * arc / c.last.arc, 1.1, 4.0);
            core::Curve again;
            again.seed = c.seed;
            again.release = c.release;
            again.duration = longer * c.duration;
            c = std::move(again);
        }
    }
}

} // namespace

DenseReference::DenseReference(const core::Flow& flow,
                               const core::Rake& rake,
                               double release,
                               Extent extent)
    : box_(flow.domain()), cell_(flow.finest_spacing()), extent_(extent) {
    const core::SeedingCurve seeding(rake);
    std::vector<double> seeds;
    constexpr int first_seeds = 513;
    for (int i = 0; i < first_seeds; ++i)
        seeds.push_back(static_cast<double>(i) / (first_seeds - 1));
    columns_ = trace(flow, seeding, seeds, release);
    const auto too_far = [&](const Column& a, const Column& b) {
        for (std::size_t j = 0; j < std::min(a.size(), b.size()); ++j)
            if (glm::distance(a[j], b[j]) > widest * cell_)
                return true;
        return false;
    };
    for (;;) {
        std::vector<double> missing;
        for (std::size_t i = 0; i + 1 < seeds.size(); ++i)
            if (seeds[i + 1] - seeds[i] > narrowest && too_far(columns_[i], columns_[i + 1]))
                missing.push_back(0.5 * (seeds[i] + seeds[i + 1]));
        if (missing.empty())
            break;
        std::vector<Column> found = trace(flow, seeding, missing, release);
        std::vector<double> all_seeds;
        std::vector<Column> all;
        for (std::size_t i = 0, m = 0; i < seeds.size(); ++i) {
            for (; m < missing.size() && missing[m] < seeds[i]; ++m) {
                all_seeds.push_back(missing[m]);
                all.push_back(std::move(found[m]));
            }
            all_seeds.push_back(seeds[i]);
            all.push_back(std::move(columns_[i]));
        }
        seeds = std::move(all_seeds);
        columns_ = std::move(all);
    }
    index_by_place();
}

std::vector<DenseReference::Column> DenseReference::trace(const core::Flow& flow,
                                                          const core::SeedingCurve& rake,
                                                          const std::vector<double>& seeds,
                                                          double release) const {
    // A few at a time: at this tolerance a curve's dense output takes megabytes.
    constexpr std::size_t together = 64;
    std::vector<Column> columns;
    for (std::size_t begin = 0; begin < seeds.size(); begin += together) {
        std::vector<core::Curve> curves(std::min(together, seeds.size() - begin));
        for (std::size_t i = 0; i < curves.size(); ++i) {
            curves[i].seed = rake.at(seeds[begin + i]);
            curves[i].release = release;
            curves[i].duration = 1.02 * extent_.time;
        }
        trace_far_enough(flow, curves, 1.02 * extent_.arc);
        // Finished curves were put behind the others: back into the order of the seeds.
        const Vec3 along = rake.at(1.0) - rake.at(0.0);
        std::sort(curves.begin(), curves.end(), [&](const auto& a, const auto& b) {
            return glm::dot(a.seed, along) < glm::dot(b.seed, along);
        });
        for (const core::Curve& curve : curves) {
            Column column;
            const double ds = spacing * cell_;
            for (double arc = 0.0; arc <= curve.last.arc; arc += ds)
                column.push_back(curve.at_arc(arc).position);
            column.push_back(curve.last.position);
            columns.push_back(std::move(column));
        }
    }
    return columns;
}

std::array<std::int64_t, 3> DenseReference::bin_of(const Vec3& point) const {
    std::array<std::int64_t, 3> bin{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double cells = std::floor((point[axis] - box_.lo[axis]) / cell_);
        bin[i] = std::clamp(static_cast<std::int64_t>(cells), std::int64_t{0}, bins_[i] - 1);
    }
    return bin;
}

void DenseReference::index_by_place() {
    for (int axis = 0; axis < 3; ++axis)
        bins_[static_cast<std::size_t>(axis)] =
            static_cast<std::int64_t>(std::ceil(box_.extent()[axis] / cell_)) + 1;
    const auto bin = [&](const Vec3& p) {
        const auto [x, y, z] = bin_of(p);
        return static_cast<std::size_t>((z * bins_[1] + y) * bins_[0] + x);
    };
    first_.assign(static_cast<std::size_t>(bins_[0] * bins_[1] * bins_[2]) + 1, 0);
    for (const Column& column : columns_)
        for (const Vec3& p : column)
            ++first_[bin(p) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i)
        first_[i] += first_[i - 1];
    nearby_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t c = 0; c < columns_.size(); ++c)
        for (std::uint32_t j = 0; j < columns_[c].size(); ++j)
            nearby_[next[bin(columns_[c][j])]++] = {columns_[c][j], c, j};
}

double DenseReference::distance(const Vec3& point) const {
    const auto at = bin_of(point);
    for (std::int64_t reach = 1; reach <= 8; reach *= 2) {
        const Vertex* nearest = nullptr;
        double least = std::numeric_limits<double>::infinity();
        const auto low = [&](int a) {
            return std::max(at[static_cast<std::size_t>(a)] - reach, std::int64_t{0});
        };
        const auto high = [&](int a) {
            const auto i = static_cast<std::size_t>(a);
            return std::min(at[i] + reach, bins_[i] - 1);
        };
        for (std::int64_t z = low(2); z <= high(2); ++z)
            for (std::int64_t y = low(1); y <= high(1); ++y) {
                const auto row = static_cast<std::size_t>((z * bins_[1] + y) * bins_[0]);
                const std::uint32_t begin = first_[row + static_cast<std::size_t>(low(0))];
                const std::uint32_t end = first_[row + static_cast<std::size_t>(high(0)) + 1];
                for (std::uint32_t i = begin; i < end; ++i) {
                    const Vec3 d = nearby_[i].position - point;
                    if (const double d2 = glm::dot(d, d); d2 < least) {
                        least = d2;
                        nearest = &nearby_[i];
                    }
                }
            }
        // Nearer vertices may lie in bins not looked at when the nearest is farther than those reach.
        if (nearest && std::sqrt(least) <= static_cast<double>(reach) * cell_)
            return to_triangles_round(*nearest, point);
    }
    return std::numeric_limits<double>::infinity();
}

double DenseReference::to_triangles_round(const Vertex& vertex, const Vec3& point) const {
    // Columns may be far closer to each other than their vertices, and sheared: the triangle that is nearest may be
    // many columns from the vertex that is nearest, but within a spacing or two of it.
    constexpr std::size_t rows = 3;
    double least = glm::distance(vertex.position, point);
    const std::size_t j0 = vertex.index < rows ? 0 : vertex.index - rows;
    // Between columns c and c + 1; false where the sheet has gone too far from the vertex.
    const auto strip = [&](std::size_t c) {
        const Column& a = columns_[c];
        const Column& b = columns_[c + 1];
        const std::size_t j1 = std::min({vertex.index + rows, a.size() - 1, b.size() - 1});
        if (j1 <= j0)
            return false;
        for (std::size_t j = j0; j < j1; ++j) {
            if (glm::distance(a[j], b[j]) > 2.0 * widest * cell_)
                continue; // a tear
            least = std::min(least, to_triangle(point, a[j], b[j], b[j + 1]));
            least = std::min(least, to_triangle(point, a[j], b[j + 1], a[j + 1]));
        }
        const std::size_t same = std::min<std::size_t>(vertex.index, j1);
        return glm::distance(a[same], vertex.position) < 2.0 * spacing * cell_;
    };
    for (std::size_t c = vertex.column; c + 1 < columns_.size() && strip(c); ++c) {
    }
    for (std::size_t c = vertex.column; c > 0 && strip(c - 1); --c) {
    }
    return least;
}

} // namespace wakesurf::bench
