#include "core/surface/lines/thinned_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

void count(const ThinnedLine& curve, LineEnds& ends) {
    if (curve.cut || curve.end == CurveEnd::Budget)
        ++ends.cut;
    else if (curve.end == CurveEnd::Domain)
        ++ends.domain;
    else if (curve.end == CurveEnd::Obstacle)
        ++ends.wall;
    else if (curve.end == CurveEnd::Stagnation)
        ++ends.rest;
    else
        ++ends.limit;
}

/// Cuts the longest curves, all at one number of points, so that there are at most so many of all.
void cut_longest(std::span<std::vector<ThinnedLine>* const> curves, std::size_t most) {
    std::vector<std::size_t> counts;
    for (const auto* each : curves)
        for (const ThinnedLine& curve : *each)
            counts.push_back(curve.points.size());
    std::sort(counts.begin(), counts.end());
    std::size_t left = most;
    std::size_t longest = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > left / (counts.size() - i)) {
            longest = std::max<std::size_t>(1, left / (counts.size() - i));
            break;
        }
        left -= counts[i];
    }
    for (auto* each : curves)
        for (ThinnedLine& curve : *each)
            if (curve.points.size() > longest) {
                curve.points.resize(longest);
                curve.cut = true;
            }
}

void append(const ThinnedLine& back,
            const ThinnedLine& forth,
            const LinePoint& seed,
            StreamLines& lines) {
    const auto add = [&](const LinePoint& point) {
        lines.points.push_back(point.place);
        lines.times.push_back(point.time);
        lines.values.push_back(point.value);
    };
    std::for_each(back.points.rbegin(), back.points.rend(), add);
    add(seed);
    std::for_each(forth.points.begin(), forth.points.end(), add);
    lines.offsets.push_back(static_cast<std::uint32_t>(lines.points.size()));
}

} // namespace

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

bool ThinnedLine::add(
    const LinePoint& next, double arc, double gap, std::size_t most, WorkMemory& memory) {
    const Vec3 way = next.place - here_.place;
    if (pending_ && (arc - kept_arc_ > gap || angle_between(kept_way_, way) > turn_between) &&
        !keep(most, memory))
        return false;
    if (points.empty() && !pending_)
        kept_way_ = way;
    here_ = next;
    here_way_ = way;
    here_arc_ = arc;
    pending_ = true;
    return true;
}

void ThinnedLine::finish(std::size_t most, WorkMemory& memory) {
    if (pending_ && !cut)
        keep(most, memory);
}

bool ThinnedLine::keep(std::size_t most, WorkMemory& memory) {
    cut = points.size() + 1 >= most;
    const std::size_t room = points.capacity();
    if (points.size() == room) {
        const std::size_t more = std::max<std::size_t>(room, 32);
        if (!memory.grow(more * line_point_bytes))
            return false;
        points.reserve(room + more);
    }
    points.push_back(here_);
    kept_way_ = here_way_;
    kept_arc_ = here_arc_;
    pending_ = false;
    return !cut;
}

std::size_t most_of_curve(std::size_t most, std::size_t seeds, Direction direction) {
    const std::size_t curves =
        std::max<std::size_t>(1, seeds * (direction == Direction::Both ? 2 : 1));
    return std::max<std::size_t>(2, shares_of_curve * most / curves);
}

void gather_lines(std::vector<ThinnedLine>& back,
                  std::vector<ThinnedLine>& forth,
                  std::span<const LinePoint> seeds,
                  Direction direction,
                  std::size_t most,
                  StreamLines& lines) {
    const std::array ways{&back, &forth};
    cut_longest(ways, std::max(most, seeds.size()) - seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        append(back[i], forth[i], seeds[i], lines);
        if (direction != Direction::Forward)
            count(back[i], lines.ends);
        if (direction != Direction::Backward)
            count(forth[i], lines.ends);
    }
}

void find_range(StreamLines& lines) {
    for (const float value : lines.values) {
        if (!std::isfinite(value))
            continue;
        const auto [least, most] = lines.range.value_or(std::array{value, value});
        lines.range = {std::min(least, value), std::max(most, value)};
    }
}

} // namespace wakesurf::core
