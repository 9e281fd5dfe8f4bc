#include "importer/assembly/meeting_points.hpp"

#include "core/base/vec3.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::importer {

using core::Vec3;

namespace {

constexpr double part_of_speed = 0.02;
constexpr double times_along_edges = 4.0;
constexpr double matter_of_rounding = 1e-5; // of 32 bits, some times over

/// Of so many points at one place every two are compared; of more each with the first and the next.
constexpr std::size_t most_compared = 16;

} // namespace

struct MeetingPoints::Velocities {
    explicit Velocities(std::span<const float> values) : all(values) {
        for (std::size_t i = 0; i < values.size() / 3; ++i)
            if (const double speed = glm::length(at(static_cast<std::uint32_t>(i)));
                std::isfinite(speed))
                highest = std::max(highest, speed);
    }

    Vec3 at(std::uint32_t point) const {
        const float* const v = all.data() + 3 * std::size_t{point};
        return {v[0], v[1], v[2]};
    }

    std::span<const float> all;
    double highest = 0.0;
};

MeetingPoints::MeetingPoints(std::span<const std::uint32_t> same,
                             std::span<const std::uint32_t> piece,
                             const std::vector<std::uint32_t>& cells)
    : wanted_(same.size(), false) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> at_place; // the lowest point, and each
    std::vector<bool> met(same.size(), false);
    for (std::uint32_t i = 0; i < same.size(); ++i)
        if (same[i] != i)
            met[i] = met[same[i]] = true;
    for (std::uint32_t i = 0; i < same.size(); ++i)
        if (met[i])
            at_place.emplace_back(same[i], i);
    std::sort(at_place.begin(), at_place.end());
    for (std::size_t begin = 0, end = 0; begin < at_place.size(); begin = end) {
        while (end < at_place.size() && at_place[end].first == at_place[begin].first)
            ++end;
        const auto element = [&](std::size_t i) {
            return cells[piece[at_place[i].second]] < cells.size();
        };
        const bool few = end - begin <= most_compared;
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t j = i + 1; j < end; ++j) {
                const bool of_elements = element(i) || element(j);
                if (i == begin || j == i + 1 || (few && !of_elements))
                    pairs_.push_back({at_place[i].second, at_place[j].second, of_elements});
            }
    }
    for (const Pair& pair : pairs_)
        if (!pair.of_elements)
            wanted_[pair.a] = wanted_[pair.b] = true;
}

void MeetingPoints::add_edge(std::uint32_t p, std::uint32_t q) {
    if (wanted_[p])
        near_.emplace_back(p, q);
    if (wanted_[q])
        near_.emplace_back(q, p);
}

bool MeetingPoints::agree(const Pair& pair, const Velocities& velocities) const {
    const Vec3 jump = velocities.at(pair.a) - velocities.at(pair.b);
    const double size = glm::length(jump);
    if (pair.of_elements ||
        !(size > part_of_speed * velocities.highest)) // also where one is no number
        return true;
    double change = 0.0;
    for (const std::uint32_t p : {pair.a, pair.b}) {
        const auto begin = std::lower_bound(near_.begin(), near_.end(), std::pair(p, 0u));
        const auto end =
            std::find_if(begin, near_.end(), [p](const auto& e) { return e.first != p; });
        // Of a corner all edges may lie where pieces meet.
        const bool away =
            std::any_of(begin, end, [&](const auto& e) { return !wanted_[e.second]; });
        for (auto at = begin; at != end; ++at)
            if (const double here =
                    std::abs(glm::dot(velocities.at(at->second) - velocities.at(p), jump / size));
                std::isfinite(here) && (!away || !wanted_[at->second]))
                change = std::max(change, here);
    }
    return !(size > times_along_edges * change);
}

void MeetingPoints::look_at(std::span<const float> values) {
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    const Velocities velocities(values);
    highest_ = std::max(highest_, static_cast<float>(velocities.highest));
    for (Pair& pair : pairs_) {
        const double size = glm::length(velocities.at(pair.a) - velocities.at(pair.b));
        if (std::isfinite(size))
            pair.most = std::max(pair.most, static_cast<float>(size));
        pair.agrees = pair.agrees && agree(pair, velocities);
    }
}

bool MeetingPoints::tears(std::span<const float> values) const {
    const Velocities velocities(values);
    const auto disagree = [&](const Pair& pair) { return !agree(pair, velocities); };
    if (std::none_of(pairs_.begin(), pairs_.end(), disagree))
        return false;
    DisjointSets nodes(wanted_.size());
    for (const Pair& pair : pairs_)
        if (!disagree(pair))
            nodes.join(pair.a, pair.b);
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
        return nodes.lowest(pair.a) != nodes.lowest(pair.b);
    });
}

void MeetingPoints::join(DisjointSets& nodes) const {
    for (const Pair& pair : pairs_)
        if (pair.agrees)
            nodes.join(pair.a, pair.b);
}

void MeetingPoints::keep_joined(std::span<const std::uint32_t> same) {
    std::erase_if(pairs_, [&](const Pair& pair) { return same[pair.a] != same[pair.b]; });
}

double MeetingPoints::largest(std::span<const std::uint32_t> same, bool joined) const {
    double out = 0.0;
    for (const Pair& pair : pairs_)
        if ((same[pair.a] == same[pair.b]) == joined)
            out = std::max(out, double{pair.most});
    return out > matter_of_rounding * double{highest_} ? out : 0.0;
}

} // namespace wakesurf::importer
