#include "core/surface/measures/residence.hpp"

#include "core/surface/measures/cut_curve.hpp"
#include "core/surface/measures/measured.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr int lines = 2048; ///< of the rake

/// Returns what of the way from a to b is inside, as parts of it; an empty range where nothing is.
std::array<double, 2> inside_of(const Box& box, const Vec3& a, const Vec3& b) {
    double first = 0.0, last = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double change = b[axis] - a[axis];
        const double to_low = box.lo[axis] - a[axis], to_high = box.hi[axis] - a[axis];
        if (change == 0.0) {
            if (to_low > 0.0 || to_high < 0.0)
                return {1.0, 0.0};
            continue;
        }
        first = std::max(first, std::min(to_low / change, to_high / change));
        last = std::min(last, std::max(to_low / change, to_high / change));
    }
    return {first, last};
}

struct Line {
    double time = 0.0;  ///< inside
    double last = -1.0; ///< age at which it is inside last; below 0: never
};

} // namespace

Residence residence(const QuadComplex& mesh,
                    std::span<const VertexFunction> bounds,
                    std::span<const double> ages,
                    double end,
                    const std::optional<Box>& box,
                    bool closed) {
    std::vector<Line> found(lines);
    visit_parts(mesh, bounds, [&](const SurfacePart& part) {
        Vec3 s = part.at_vertices(mesh.s);
        if (closed && std::max({s.x, s.y, s.z}) - std::min({s.x, s.y, s.z}) > 0.5)
            for (int i = 0; i < 3; ++i)
                s[i] += s[i] < 0.5 ? 1.0 : 0.0;
        const Vec3 age = part.at_vertices(ages);
        const auto place = [&](const Vec3& at) {
            Vec3 p(0.0);
            for (int i = 0; i < 3; ++i)
                p += at[i] * mesh.position[part.vertex[i]];
            return p;
        };
        double low = 2.0, high = -1.0;
        for (const PartSide& side : part.sides) {
            low = std::min(low, glm::dot(s, side.begin));
            high = std::max(high, glm::dot(s, side.begin));
        }
        // Each line lies half-way between two of 2048 steps, from one part to the next without a gap.
        const int first = static_cast<int>(std::ceil(low * lines - 0.5));
        for (int k = first; (k + 0.5) / lines < high; ++k) {
            const double here = (k + 0.5) / lines;
            std::array<Vec3, 2> ends;
            int count = 0;
            for (const PartSide& side : part.sides) {
                const double a = glm::dot(s, side.begin), b = glm::dot(s, side.end);
                if ((a <= here) != (b <= here) && count < 2)
                    ends[count++] = side.begin + (here - a) / (b - a) * (side.end - side.begin);
            }
            if (count < 2)
                continue;
            if (glm::dot(age, ends[0]) > glm::dot(age, ends[1]))
                std::swap(ends[0], ends[1]);
            const double from = glm::dot(age, ends[0]), to = glm::dot(age, ends[1]);
            const auto within =
                box ? inside_of(*box, place(ends[0]), place(ends[1])) : std::array{0.0, 1.0};
            if (!(within[0] < within[1]))
                continue;
            Line& line = found[static_cast<std::size_t>((k % lines + lines) % lines)];
            line.time += (within[1] - within[0]) * (to - from);
            line.last = std::max(line.last, from + within[1] * (to - from));
        }
    });
    Residence out{not_known, not_known, not_known};
    std::vector<WeightedValue> times;
    double sum = 0.0;
    for (const Line& line : found)
        if (line.last >= 0.0) {
            times.push_back({line.time, 1.0});
            sum += line.time;
            out.inside += line.last >= end * (1.0 - 1e-6) ? 1.0 : 0.0;
        }
    if (times.empty())
        return out;
    const auto entered = static_cast<double>(times.size());
    out.entered = entered / lines;
    out.inside /= entered;
    out.mean = sum / entered;
    out.median = weighted_quantile(times, 0.5);
    out.p90 = weighted_quantile(times, 0.9);
    return out;
}

} // namespace wakesurf::core
