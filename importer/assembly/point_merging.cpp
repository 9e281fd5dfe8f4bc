#include "importer/assembly/point_merging.hpp"

#include "core/base/box.hpp"
#include "core/base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace wakesurf::importer {

using core::Vec3;

namespace {

/// With more pieces than this, comparing their boxes costs more than it saves: every point is compared.
constexpr std::size_t most_boxes = 64;

std::vector<core::Box> boxes_of(const BlockPoints& points, double margin) {
    std::vector<core::Box> boxes(points.pieces, core::Box{Vec3(HUGE_VAL), Vec3(-HUGE_VAL)});
    for (std::size_t i = 0; i < points.at.size(); ++i)
        if (points.used[i]) {
            core::Box& box = boxes[points.piece[i]];
            box.lo = glm::min(box.lo, points.at[i] - margin);
            box.hi = glm::max(box.hi, points.at[i] + margin);
        }
    return boxes;
}

bool inside(const core::Box& box, const Vec3& p) {
    return glm::all(glm::lessThanEqual(box.lo, p)) && glm::all(glm::lessThanEqual(p, box.hi));
}

// Hashes points into buckets of space that are a few times as wide as points reach.
class Buckets {
  public:
    explicit Buckets(const BlockPoints& points)
        : points_(points),
          reach_(static_cast<double>(*std::max_element(points.reach.begin(), points.reach.end()))),
          width_(8.0 * reach_) {
        const auto boxes =
            points.pieces > most_boxes ? std::vector<core::Box>() : boxes_of(points, reach_);
        for (std::size_t i = 0; i < points.at.size(); ++i)
            if (points.used[i] && (boxes.empty() || shared(boxes, points.piece[i], points.at[i])))
                entries_.push_back({bucket(points.at[i]), static_cast<std::uint32_t>(i)});
        std::sort(entries_.begin(), entries_.end());
    }

    struct Entry {
        std::uint64_t bucket;
        std::uint32_t point;

        bool operator<(const Entry& other) const {
            return bucket != other.bucket ? bucket < other.bucket : point < other.point;
        }
    };

    const std::vector<Entry>& entries() const { return entries_; }

    template <class Visit>
    void visit_near(std::uint32_t point, const Visit& visit) const {
        const Vec3& p = points_.at[point];
        std::array<std::uint64_t, 8> seen{};
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const Vec3 q =
                p + reach_ * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            const std::uint64_t key = seen[corner] = bucket(q);
            auto* const here = seen.data() + corner;
            if (std::find(seen.data(), here, key) != here)
                continue;
            auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{key, 0});
            for (; at != entries_.end() && at->bucket == key; ++at)
                if (at->point != point &&
                    glm::length(points_.at[at->point] - p) <=
                        double{std::min(points_.reach[point], points_.reach[at->point])})
                    visit(at->point);
        }
    }

  private:
    static bool shared(const std::vector<core::Box>& boxes, std::size_t piece, const Vec3& p) {
        for (std::size_t b = 0; b < boxes.size(); ++b)
            if (b != piece && inside(boxes[b], p))
                return true;
        return false;
    }

    std::uint64_t bucket(const Vec3& p) const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto index = static_cast<std::int64_t>(std::floor(p[axis] / width_));
            hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 29;
        }
        return hash;
    }

    const BlockPoints& points_;
    double reach_;
    double width_;
    std::vector<Entry> entries_;
};

// Joins points at places where one piece has several: those of two pieces that have a face between the same
// places.
void join_by_faces(const BlockPoints& points,
                   const FacesAt& faces_at,
                   const std::vector<bool>& marked,
                   DisjointSets& places,
                   DisjointSets& nodes) {
    std::map<std::vector<std::uint32_t>, std::vector<FacePoints>> by_places;
    for (auto& face : faces_at(marked)) {
        std::vector<std::uint32_t> key;
        for (const std::uint32_t point : face)
            key.push_back(places.lowest(point));
        std::sort(key.begin(), key.end());
        by_places[key].push_back(std::move(face));
    }
    for (const auto& [key, faces] : by_places) {
        if (faces.size() != 2 || points.piece[faces[0][0]] == points.piece[faces[1][0]])
            continue; // inside a piece, or between more than two cells
        for (const std::uint32_t a : faces[0])
            for (const std::uint32_t b : faces[1])
                if (marked[a] && places.lowest(a) == places.lowest(b))
                    nodes.join(a, b);
    }
}

// Marks the points of places at which a piece has several.
std::vector<bool> crowded(const BlockPoints& points,
                          const std::vector<Buckets::Entry>& entries,
                          DisjointSets& places) {
    struct Taken {
        std::uint32_t place;
        std::uint32_t piece;
        auto operator<=>(const Taken&) const = default;
    };

    std::vector<Taken> taken;
    taken.reserve(entries.size());
    for (const auto& entry : entries)
        taken.push_back({places.lowest(entry.point), points.piece[entry.point]});
    std::sort(taken.begin(), taken.end());
    std::vector<std::uint32_t> full;
    for (std::size_t i = 1; i < taken.size(); ++i)
        if (taken[i] == taken[i - 1])
            full.push_back(taken[i].place);
    std::vector<bool> marked(full.empty() ? 0 : points.at.size(), false);
    for (const auto& entry : entries)
        if (!full.empty() &&
            std::binary_search(full.begin(), full.end(), places.lowest(entry.point)))
            marked[entry.point] = true;
    return marked;
}

} // namespace

std::vector<std::uint32_t> merge_points(const BlockPoints& points, const FacesAt& faces_at) {
    const std::size_t count = points.at.size();
    DisjointSets places(count);
    const Buckets buckets(points);
    for (const auto& entry : buckets.entries())
        buckets.visit_near(entry.point, [&](std::uint32_t other) {
            if (other > entry.point)
                places.join(entry.point, other);
        });
    const std::vector<bool> marked = crowded(points, buckets.entries(), places);
    DisjointSets nodes(count);
    for (const auto& entry : buckets.entries())
        if (marked.empty() || !marked[entry.point])
            nodes.join(places.lowest(entry.point), entry.point);
    if (!marked.empty())
        join_by_faces(points, faces_at, marked, places, nodes);
    std::vector<std::uint32_t> merged(count);
    for (std::uint32_t i = 0; i < count; ++i)
        merged[i] = nodes.lowest(i);
    return merged;
}

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

void MeetingPoints::take(std::span<const float> values) {
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

namespace {

/// A part of the box: coordinates may be in single precision, and OpenFOAM matches faces by 1e-4 of their size.
constexpr double slack = 1e-6;

// Of a grid whose nodes lie in planes, whose sizes are equal.
OppositeNodes of_planes(const std::array<std::size_t, 3>& size, std::size_t axis) {
    OppositeNodes pairs;
    std::array<std::size_t, 3> at{};
    for (at[2] = 0; at[2] < size[2]; ++at[2])
        for (at[1] = 0; at[1] < size[1]; ++at[1])
            for (at[0] = 0; at[0] < size[0]; ++at[0]) {
                if (at[axis] != 0)
                    continue;
                std::array<std::size_t, 3> other = at;
                other[axis] = size[axis] - 1;
                const auto node = [&](const auto& n) {
                    return static_cast<std::uint32_t>(n[0] + size[0] * (n[1] + size[1] * n[2]));
                };
                pairs.push_back({node(at), node(other)});
            }
    return pairs;
}

/// A node of a side by its place there, in units of the slack.
struct SideNode {
    double u, v;
    std::uint32_t node;
};

std::vector<SideNode>
nodes_of_side(const core::CellMesh& mesh, std::size_t count, int axis, double side, double off) {
    std::vector<SideNode> out;
    for (std::size_t i = 0; i < count; ++i) {
        const core::Vec3& p = mesh.points[i];
        if (std::abs(p[axis] - side) <= off)
            out.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], static_cast<std::uint32_t>(i)});
    }
    std::ranges::sort(out, {}, &SideNode::u);
    return out;
}

tl::unexpected<core::Error> no_match(std::size_t axis, std::size_t lacking, std::size_t of) {
    return core::fail(
        core::Error::Code::Unsupported,
        "cannot repeat along " + std::string(1, "xyz"[axis]) + ": " + std::to_string(lacking) +
            " of " + std::to_string(of) + " nodes on one side of its box have none on the other",
        "both sides need the same nodes, with the first plane of them again as the last one");
}

core::Result<OppositeNodes>
of_mesh(const core::CellMesh& mesh, std::size_t count, std::size_t axis) {
    const core::Box box = core::bounds(mesh);
    const int along = static_cast<int>(axis);
    const double off = slack * box.diagonal();
    const auto low = nodes_of_side(mesh, count, along, box.lo[along], off);
    auto high = nodes_of_side(mesh, count, along, box.hi[along], off);
    if (low.empty() || high.empty())
        return core::fail(core::Error::Code::Unsupported,
                          "cannot repeat along " + std::string(1, "xyz"[axis]) +
                              ": it has no nodes on a side of its box",
                          "leave that axis out");
    OppositeNodes pairs;
    std::vector<bool> taken(high.size(), false);
    for (const SideNode& node : low) {
        const auto first = std::ranges::lower_bound(high, node.u - off, {}, &SideNode::u);
        for (auto at = first; at != high.end() && at->u <= node.u + off; ++at) {
            const auto i = static_cast<std::size_t>(at - high.begin());
            if (taken[i] || std::abs(at->v - node.v) > off)
                continue;
            taken[i] = true;
            pairs.push_back({node.node, at->node});
            break;
        }
    }
    if (pairs.size() != low.size())
        return no_match(axis, low.size() - pairs.size(), low.size());
    if (pairs.size() != high.size())
        return no_match(axis, high.size() - pairs.size(), high.size());
    return pairs;
}

} // namespace

core::Result<OppositeNodes>
opposite_nodes(const core::Grid& grid, std::size_t axis, std::size_t nodes) {
    if (const auto* uniform = std::get_if<core::UniformGrid>(&grid))
        return of_planes({uniform->dimensions[0], uniform->dimensions[1], uniform->dimensions[2]},
                         axis);
    if (const auto* rectilinear = std::get_if<core::RectilinearGrid>(&grid)) {
        const auto& [x, y, z] = rectilinear->coordinates;
        return of_planes({x.size(), y.size(), z.size()}, axis);
    }
    return of_mesh(std::get<core::CellMesh>(grid), nodes, axis);
}

} // namespace wakesurf::importer
