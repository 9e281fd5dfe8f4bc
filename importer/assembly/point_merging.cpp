#include "importer/assembly/point_merging.hpp"

#include "core/base/box.hpp"
#include "importer/assembly/disjoint_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

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

} // namespace wakesurf::importer
