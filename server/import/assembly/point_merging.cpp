#include "server/import/assembly/point_merging.hpp"

#include "core/base/box.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace wakesurf::server {

using core::Vec3;

namespace {

constexpr std::uint32_t nowhere = 0xffffffffu;

class Sets {
  public:
    explicit Sets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    std::uint32_t lowest(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = lowest(a);
        b = lowest(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

std::vector<core::Box> boxes_of(const BlockPoints& points, double margin) {
    std::vector<core::Box> boxes;
    for (std::size_t b = 0; b + 1 < points.first.size(); ++b) {
        core::Box box{Vec3(HUGE_VAL), Vec3(-HUGE_VAL)};
        for (std::size_t i = points.first[b]; i < points.first[b + 1]; ++i)
            if (points.used[i]) {
                box.lo = glm::min(box.lo, points.at[i] - margin);
                box.hi = glm::max(box.hi, points.at[i] + margin);
            }
        boxes.push_back(box);
    }
    return boxes;
}

bool inside(const core::Box& box, const Vec3& p) {
    return glm::all(glm::lessThanEqual(box.lo, p)) && glm::all(glm::lessThanEqual(p, box.hi));
}

// Buckets of space a few tolerances wide, by a hash of where they lie.
class Buckets {
  public:
    Buckets(const BlockPoints& points, double tolerance)
        : points_(points), tolerance_(tolerance), width_(8.0 * tolerance) {
        const auto boxes = boxes_of(points, tolerance);
        for (std::uint32_t b = 0; b + 1 < points.first.size(); ++b)
            for (std::size_t i = points.first[b]; i < points.first[b + 1]; ++i)
                if (points.used[i] && shared(boxes, b, points.at[i]))
                    entries_.push_back({bucket(points.at[i]), static_cast<std::uint32_t>(i), b});
        std::sort(entries_.begin(), entries_.end());
    }

    struct Entry {
        std::uint64_t bucket;
        std::uint32_t point;
        std::uint32_t block;

        bool operator<(const Entry& other) const {
            return bucket != other.bucket ? bucket < other.bucket : point < other.point;
        }
    };

    const std::vector<Entry>& entries() const { return entries_; }

    template <class Visit>
    void visit_near(const Entry& entry, const Visit& visit) const {
        const Vec3& p = points_.at[entry.point];
        std::set<std::uint64_t> seen;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 q = p + tolerance_ * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                                 corner & 4 ? 1 : -1);
            const std::uint64_t key = bucket(q);
            if (!seen.insert(key).second)
                continue;
            auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{key, 0, 0});
            for (; at != entries_.end() && at->bucket == key; ++at)
                if (at->point != entry.point &&
                    glm::length(points_.at[at->point] - p) <= tolerance_)
                    visit(*at);
        }
    }

  private:
    static bool shared(const std::vector<core::Box>& boxes, std::size_t block, const Vec3& p) {
        for (std::size_t b = 0; b < boxes.size(); ++b)
            if (b != block && inside(boxes[b], p))
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
    double tolerance_;
    double width_;
    std::vector<Entry> entries_;
};

// Places with several points of one block: their points are joined where two blocks have a face between the same places.
void join_by_faces(const FacesAt& faces_at,
                   const std::vector<bool>& marked,
                   Sets& places,
                   Sets& nodes) {
    std::map<std::vector<std::uint32_t>, std::vector<BlockFace>> by_places;
    for (auto& face : faces_at(marked)) {
        std::vector<std::uint32_t> key;
        for (const std::uint32_t point : face.points)
            key.push_back(places.lowest(point));
        std::sort(key.begin(), key.end());
        by_places[key].push_back(std::move(face));
    }
    for (const auto& [key, faces] : by_places) {
        if (faces.size() != 2 || faces[0].block == faces[1].block)
            continue; // inside a block, or between more than two cells
        for (const std::uint32_t a : faces[0].points)
            for (const std::uint32_t b : faces[1].points)
                if (marked[a] && places.lowest(a) == places.lowest(b))
                    nodes.join(a, b);
    }
}

} // namespace

std::vector<std::uint32_t>
merge_points(const BlockPoints& points, double tolerance, const FacesAt& faces_at) {
    const std::size_t count = points.at.size();
    Sets places(count);
    const Buckets buckets(points, tolerance);
    for (const auto& entry : buckets.entries())
        buckets.visit_near(entry, [&](const auto& other) {
            if (other.point > entry.point)
                places.join(entry.point, other.point);
        });
    // Which block already has a point at a place, by the place's lowest point.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> taken;
    std::set<std::uint32_t> crowded;
    for (const auto& entry : buckets.entries()) {
        const std::uint32_t place = places.lowest(entry.point);
        if (!taken.emplace(std::pair(place, entry.block), entry.point).second)
            crowded.insert(place);
    }
    Sets nodes(count);
    std::vector<bool> marked(crowded.empty() ? 0 : count, false);
    for (const auto& entry : buckets.entries()) {
        const std::uint32_t place = places.lowest(entry.point);
        if (crowded.contains(place))
            marked[entry.point] = true;
        else
            nodes.join(place, entry.point);
    }
    if (!crowded.empty())
        join_by_faces(faces_at, marked, places, nodes);
    std::vector<std::uint32_t> merged(count, nowhere);
    for (std::uint32_t i = 0; i < count; ++i)
        merged[i] = nodes.lowest(i);
    return merged;
}

} // namespace wakesurf::server
