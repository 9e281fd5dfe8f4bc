#include "core/surface/measures/cut_curve.hpp"

#include "core/surface/measures/measured.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

double weighted_quantile(std::vector<WeightedValue>& values, double share) {
    std::ranges::sort(values, {}, &WeightedValue::value);
    double all = 0.0;
    for (const WeightedValue& one : values)
        all += one.weight;
    double sum = 0.0;
    for (const WeightedValue& one : values)
        if (one.weight > 0.0 && (sum += one.weight) >= share * all)
            return one.value;
    return not_known;
}

namespace {

/// How functions change in a triangle.
class TriangleSlopes {
  public:
    TriangleSlopes(const QuadComplex& mesh, const std::array<VertexId, 3>& corner) {
        const Vec3 a = mesh.position[corner[1]] - mesh.position[corner[0]];
        const Vec3 b = mesh.position[corner[2]] - mesh.position[corner[0]];
        aa_ = glm::dot(a, a);
        ab_ = glm::dot(a, b);
        bb_ = glm::dot(b, b);
    }

    /// Returns how much g changes where f changes by one, on the shortest way.
    double of(const Vec3& g, const Vec3& f) const { return product(g, f) / product(f, f); }

  private:
    /// The product of two gradients, but for a factor that is the triangle's.
    double product(const Vec3& g, const Vec3& f) const {
        const double g1 = g.y - g.x, g2 = g.z - g.x, f1 = f.y - f.x, f2 = f.z - f.x;
        return bb_ * g1 * f1 - ab_ * (g1 * f2 + g2 * f1) + aa_ * g2 * f2;
    }

    double aa_, ab_, bb_;
};

} // namespace

CutCurve cut_curve(const QuadComplex& mesh,
                   std::span<const VertexFunction> bounds,
                   std::size_t others,
                   std::span<const double> ages,
                   std::span<const std::span<const double>> errors) {
    CutCurve out{0.0, not_known, not_known, not_known, {}};
    const bool aged = !ages.empty();
    double least = std::numeric_limits<double>::infinity();
    std::vector<WeightedValue> arrivals;
    std::vector<std::vector<WeightedValue>> off(errors.size());
    visit_parts(mesh, bounds, [&](const SurfacePart& part) {
        for (const PartSide& side : part.sides) {
            if (side.bound < static_cast<int>(others))
                continue;
            const Vec3 middle = 0.5 * (side.begin + side.end), change = side.end - side.begin;
            Vec3 along(0.0);
            for (int i = 0; i < 3; ++i)
                along += change[i] * mesh.position[part.vertex[i]];
            const double length = glm::length(along);
            out.length += length;
            if (!aged)
                continue;
            const Vec3 age = part.at_vertices(ages);
            const Vec3 inside = part.at_vertices(bounds[static_cast<std::size_t>(side.bound)]);
            const double later = TriangleSlopes(mesh, part.vertex).of(age, inside);
            const bool leaves = bounds.size() - others > 1 && later < 0.0; // a box
            if (!leaves) {
                arrivals.push_back({glm::dot(age, middle), length});
                least = std::min({least, glm::dot(age, side.begin), glm::dot(age, side.end)});
            }
            for (std::size_t k = 0; k < errors.size(); ++k) {
                const double error = glm::dot(part.at_vertices(errors[k]), middle);
                if (std::isfinite(error) && std::isfinite(later))
                    off[k].push_back({error * std::abs(later), length});
            }
        }
    });
    if (!arrivals.empty()) {
        out.least = least;
        out.median = weighted_quantile(arrivals, 0.5);
        out.p90 = weighted_quantile(arrivals, 0.9);
    }
    for (std::vector<WeightedValue>& one : off) {
        double length = 0.0;
        for (const WeightedValue& piece : one)
            length += piece.weight;
        out.error99.push_back(length > 0.5 * out.length ? weighted_quantile(one, 0.99) : not_known);
    }
    return out;
}

} // namespace wakesurf::core
