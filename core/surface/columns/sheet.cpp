#include "core/surface/columns/sheet.hpp"

#include "core/base/for_each_index.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace wakesurf::core {

namespace {

struct Face {
    glm::vec3 normal;      ///< of length 1, or 0 where the cell has no area
    std::uint32_t last[2]; ///< vertex of its left and of its right column where it ends
};

/// The cells of a strip, as far as their neighbours across a column need to know them.
struct StripFaces {
    struct CellOfNode {
        std::int32_t node;
        std::uint32_t row;
    };

    const Strip* strip = nullptr;
    std::vector<const Vec3*> position; ///< by column
    std::vector<std::uint32_t> offset; ///< by node: of its first cell in `faces`
    std::vector<Face> faces;
    std::vector<CellOfNode> bent;

    const Vec3& at(const StripVertex& v) const { return position[v.column][v.index]; }

    /// Square to both diagonals, twice as long as the cell is large.
    Vec3 area(const StripCell& cell) const {
        const auto& [a, b, c, d] = cell.corner;
        return glm::cross(at(c) - at(a), at(d) - at(b));
    }

    /// Returns the width square to the columns.
    double width(const StripCell& cell) const {
        const auto& [a, b, c, d] = cell.corner;
        const double along = glm::length((at(c) - at(b)) + (at(d) - at(a)));
        return along > 0.0 ? glm::length(area(cell)) / along : 0.0;
    }

    void add(std::int32_t node) {
        offset[static_cast<std::size_t>(node)] = static_cast<std::uint32_t>(faces.size());
        for (const StripCell& cell : strip->cells(node)) {
            const Vec3 twice = area(cell);
            const double square = glm::dot(twice, twice);
            const double scale = square > 0.0 ? 1.0 / std::sqrt(square) : 0.0;
            faces.push_back(
                {glm::vec3(twice * scale), {cell.corner[3].index, cell.corner[2].index}});
        }
        for (std::size_t side = 0; side < 2; ++side)
            if (const std::int32_t child = strip->child(node, side); child >= 0)
                add(child);
    }

    void make(const Strip& from) {
        strip = &from;
        for (const StripColumn& column : from.columns())
            position.push_back(column.column->position.data());
        offset.resize(from.nodes());
        faces.reserve(from.quads());
        add(0);
    }
};

/// Visits the cells on one side of a column, one after the other from its first vertex on.
class ColumnSide {
  public:
    /// @param node  where they begin; those of its child number `side` follow, and so on
    ColumnSide(StripFaces& faces, std::int32_t node, std::size_t side)
        : faces_(faces), node_(node), side_(side) {
        enter();
    }

    bool ended() const { return node_ < 0; }

    const glm::vec3& normal() const { return face_[row_].normal; }

    /// Vertex of the column where the cell ends.
    std::uint32_t last() const { return face_[row_].last[side_]; }

    double width() const { return faces_.width(faces_.strip->cells(node_)[row_]); }

    void mark() { faces_.bent.push_back({node_, static_cast<std::uint32_t>(row_)}); }

    void next() {
        if (++row_ == rows_) {
            node_ = faces_.strip->child(node_, side_);
            enter();
        }
    }

  private:
    void enter() {
        for (row_ = 0; node_ >= 0; node_ = faces_.strip->child(node_, side_)) {
            rows_ = faces_.strip->cells(node_).size();
            face_ = faces_.faces.data() + faces_.offset[static_cast<std::size_t>(node_)];
            if (rows_ > 0)
                return;
        }
    }

    StripFaces& faces_;
    std::int32_t node_;
    std::size_t side_;
    std::size_t row_ = 0;
    std::size_t rows_ = 0;
    const Face* face_ = nullptr;
};

class Bends {
  public:
    Bends(double least_cosine, double least_width)
        : least_cosine_(static_cast<float>(least_cosine)), least_width_(least_width) {}

    /// Compares the cells on the left of a column with those on its right.
    void mark(ColumnSide left, ColumnSide right) const {
        while (!left.ended() && !right.ended()) {
            if (glm::dot(left.normal(), right.normal()) < least_cosine_)
                mark_wide(left, right);
            const bool next_left = left.last() <= right.last();
            const bool next_right = right.last() <= left.last();
            if (next_left)
                left.next();
            if (next_right)
                right.next();
        }
    }

  private:
    /// A cell much narrower than the other has done its part; that of a sliver, whose sides lie closer than
    /// they are curved, points anywhere.
    void mark_wide(ColumnSide& a, ColumnSide& b) const {
        const double a_width = a.width();
        const double b_width = b.width();
        if (std::min(a_width, b_width) < 0.2 * least_width_)
            return;
        if (a_width > least_width_ && a_width > 0.5 * b_width)
            a.mark();
        if (b_width > least_width_ && b_width > 0.5 * a_width)
            b.mark();
    }

    float least_cosine_;
    double least_width_;
};

void mark_inner_columns(const Bends& bends, StripFaces& faces, std::int32_t node) {
    const std::int32_t left = faces.strip->child(node, 0);
    const std::int32_t right = faces.strip->child(node, 1);
    if (left < 0)
        return;
    bends.mark({faces, left, 1}, {faces, right, 0});
    mark_inner_columns(bends, faces, left);
    mark_inner_columns(bends, faces, right);
}

/// Returns for every strip and node of its tree the first of its rows that bends and is wide enough to be
/// split, or Strip::no_row. Inner vectors of strips that bend nowhere are empty.
/// @param closed        the last strip's right column is the first one's left
/// @param least_cosine  of the angle between the normals of cells that may stay
/// Cost: O(quads), in parallel.
std::vector<std::vector<std::uint32_t>>
find_bends(std::span<const Strip> strips, bool closed, double least_cosine, double least_width) {
    const Bends bends(least_cosine, least_width);
    std::vector<StripFaces> all(strips.size());
    for_each_index(
        strips.size(),
        [&](std::size_t i) {
            all[i].make(strips[i]);
            mark_inner_columns(bends, all[i], 0);
        },
        1);
    const auto mark_right_of = [&](std::size_t i) {
        bends.mark({all[i], 0, 1}, {all[(i + 1) % all.size()], 0, 0});
    };
    for (std::size_t odd = 0; odd < 2; ++odd) // every second column, so that no strip is on two
        for_each_index(
            all.size() / 2,
            [&](std::size_t i) {
                if (2 * i + odd + 1 < all.size())
                    mark_right_of(2 * i + odd);
            },
            1);
    if (closed && !all.empty())
        mark_right_of(all.size() - 1);
    std::vector<std::vector<std::uint32_t>> rows(strips.size());
    for (std::size_t i = 0; i < strips.size(); ++i)
        for (const auto& [node, row] : all[i].bent) {
            if (rows[i].empty())
                rows[i].assign(strips[i].nodes(), Strip::no_row);
            std::uint32_t& first = rows[i][static_cast<std::size_t>(node)];
            first = std::min(first, row);
        }
    return rows;
}

constexpr double spacing_of_separation =
    0.75; // square cells on average: fronts are between 1/2 and 1 separation
constexpr double tear_width = 1.0 / 16.0; // of the separation
constexpr double least_interval = 1e-6;   // of the rake
constexpr int most_sheet_rounds = 128;
constexpr double bend_width =
    1.0 / 8.0; // of the separation: no strip becomes narrower because the sheet bends
constexpr int most_bend_rounds = 32;
// A quad takes its cell in a vector that grows by doubling, its columns' vertices, its part of the tree. With
// 160 bytes a large sheet was seen to hold a quarter more than it had reported.
constexpr std::size_t strip_bytes = 200;

/// Up to so many quads may become one where seeds are close.
constexpr std::size_t most_joined = 16;

/// Returns how much a column may turn from one vertex to the next. A quad's side may take two segments, and
/// cells meet at the turn of a whole side.
double most_turn(double angle) {
    return angle < 180.0 ? 0.5 * angle * std::numbers::pi / 180.0 : std::numbers::pi;
}

double elapsed(const Clock& clock, std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(clock.now() - since).count();
}

} // namespace

Sheet::Sheet(const Flow& flow, SeedingCurve seeding, SheetOptions options)
    : flow_(flow), seeding_(std::move(seeding)),
      options_(options), limits_{
                             {&flow, options.separation, flow.obstacle()},
                             {spacing_of_separation * options.separation, most_turn(options.angle)},
                             tear_width * options.separation,
                             least_interval} {}

Result<void>
Sheet::trace(const std::set<double>& parameters, const Clock& clock, const std::stop_token& stop) {
    const auto start = clock.now();
    std::vector<double> missing;
    std::vector<Curve> batch;
    for (const double s : parameters) {
        if (curve_at_.contains(s))
            continue;
        missing.push_back(s);
        Curve curve;
        curve.seed = seeding_.at(s);
        curve.seed_tangent = seeding_.tangent(s);
        curve.release = options_.release;
        curve.duration = options_.duration;
        batch.push_back(std::move(curve));
    }
    const auto traced = flow_.trace(batch, options_.trace, stop);
    if (!traced)
        return tl::unexpected(traced.error());
    for (std::size_t i = 0; i < batch.size(); ++i)
        curve_at_[missing[i]] =
            &curves_.emplace_back(SeededCurve{missing[i], std::move(batch[i]), {}});
    seconds_.load += traced->load;
    seconds_.advect += elapsed(clock, start) - traced->load;
    return {};
}

/// Counts the memory of so many quads of strips. @param counted  quads until now
Result<void> Sheet::hold(std::size_t quads, std::size_t& counted, const WorkPart& work) const {
    const std::size_t more = quads - std::min(quads, counted);
    counted += more;
    return work.takes(more * strip_bytes);
}

Strip Sheet::strip_between(double left, double right_s) const {
    return Strip(*curve_at_.at(left), *curve_at_.at(right_s == 1.0 && closed() ? 0.0 : right_s),
                 right_s);
}

/// The columns that strips end at, each made once for the strips on either side.
void Sheet::make_end_columns(const std::stop_token& stop) {
    std::vector<SeededCurve*> ends;
    for (const double s : seeds_)
        if (SeededCurve* end = curve_at_.at(s); end->column.position.empty())
            ends.push_back(end);
    for_each_index(
        ends.size(),
        [&](std::size_t i) {
            if (!stop.stop_requested())
                ends[i]->column = make_column(ends[i]->s, ends[i]->curve, 0.0, limits_.spacing);
        },
        1);
}

/// Returns the quads that there are then. Error: Cancelled.
Result<std::size_t>
Sheet::zip(const std::vector<std::size_t>& dirty, const Clock& clock, const std::stop_token& stop) {
    const auto start = clock.now();
    make_end_columns(stop);
    for_each_index(
        dirty.size(),
        [&](std::size_t i) {
            if (!stop.stop_requested())
                strips_[dirty[i]].zip(limits_);
        },
        1);
    if (stop.stop_requested())
        return fail(Error::Code::Cancelled, "the surface was cancelled");
    seconds_.refine += elapsed(clock, start);
    return quads();
}

std::uint64_t Sheet::quads() const {
    std::uint64_t sum = 0;
    for (const Strip& strip : strips_)
        sum += strip.quads();
    return sum;
}

/// Replaces each strip that holds a new seed by two.
void Sheet::cut_at(const std::vector<double>& new_seeds) {
    std::vector<Strip> strips;
    std::size_t next = 0;
    for (Strip& strip : strips_) {
        if (next < new_seeds.size() && new_seeds[next] > strip.left_s() &&
            new_seeds[next] < strip.right_s()) {
            strips.push_back(strip_between(strip.left_s(), new_seeds[next]));
            strips.push_back(strip_between(new_seeds[next], strip.right_s()));
            ++next;
        } else {
            strips.push_back(std::move(strip));
        }
    }
    strips_ = std::move(strips);
}

/// Returns the part of the rake that lies before the strips that are not done.
double Sheet::part_without(const std::vector<std::size_t>& dirty) const {
    double rest = 0.0;
    for (const std::size_t i : dirty)
        rest += strips_[i].right_s() - strips_[i].left_s();
    return 1.0 - rest;
}

Result<bool> Sheet::build(const std::set<double>& seeds,
                          const Clock& clock,
                          std::stop_token stop,
                          WorkPart work) {
    seeds_ = seeds;
    if (auto traced = trace(seeds_, clock, stop); !traced)
        return tl::unexpected(traced.error());
    double arc = 0.0;
    for (const SeededCurve& curve : curves_)
        arc += curve.curve.last.arc;
    const auto expected = static_cast<std::size_t>(arc / limits_.spacing.longest);
    if (expected / most_joined > options_.max_quads)
        return false;
    std::size_t counted = 0;
    if (auto held = hold(expected, counted, work); !held)
        return tl::unexpected(held.error());

    strips_.clear();
    for (auto left = seeds_.begin(); left != seeds_.end(); ++left)
        if (const auto right = std::next(left); right != seeds_.end())
            strips_.push_back(strip_between(*left, *right));
        else if (closed())
            strips_.push_back(strip_between(*left, 1.0));
    std::vector<std::size_t> dirty(strips_.size());
    std::iota(dirty.begin(), dirty.end(), std::size_t{0});
    int round = 0;
    for (int bend_round = 0;;) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        std::vector<StripDemand> demands;
        if (dirty.empty()) {
            if (bend_round++ < most_bend_rounds)
                demands = bend_demands(clock);
            if (demands.empty())
                break;
            round = 0;
        } else {
            const auto quads = zip(dirty, clock, stop);
            if (!quads)
                return tl::unexpected(quads.error());
            if (*quads > options_.max_quads)
                return false;
            if (auto held = hold(*quads, counted, work); !held)
                return tl::unexpected(held.error());
            work.has(*quads);
            for (const std::size_t i : dirty)
                if (round >= most_sheet_rounds)
                    strips_[i].tear_rest();
                else
                    demands.push_back({i, strips_[i].refine(limits_)});
            ++round;
        }
        auto again = meet(demands, clock, stop);
        if (!again)
            return tl::unexpected(again.error());
        dirty = std::move(*again);
        work.reached(part_without(dirty));
    }
    return true;
}

/// Returns what the strips want where the sheet bends, only for strips that want something.
std::vector<Sheet::StripDemand> Sheet::bend_demands(const Clock& clock) {
    std::vector<StripDemand> demands;
    if (options_.angle >= 180.0)
        return demands;
    const auto start = clock.now();
    const double cosine = std::cos(options_.angle * std::numbers::pi / 180.0);
    const auto rows = find_bends(strips_, closed(), cosine, 2.0 * bend_width * options_.separation);
    for (std::size_t i = 0; i < strips_.size(); ++i)
        if (!rows[i].empty())
            if (auto demand = strips_[i].split_bends(limits_, rows[i]); demand.changed)
                demands.push_back({i, std::move(demand)});
    seconds_.refine += elapsed(clock, start);
    return demands;
}

/// Hands strips the curves and seeds they want. Returns the strips to zip again.
Result<std::vector<std::size_t>> Sheet::meet(const std::vector<StripDemand>& demands,
                                             const Clock& clock,
                                             const std::stop_token& stop) {
    std::set<double> wanted;
    std::vector<double> new_seeds;
    std::vector<std::size_t> again;
    for (const auto& [i, demand] : demands) {
        if (demand.new_seed) {
            wanted.insert(*demand.new_seed);
            new_seeds.push_back(*demand.new_seed);
        } else {
            wanted.insert(demand.middles.begin(), demand.middles.end());
        }
        if (demand.changed)
            again.push_back(i);
    }
    if (auto traced = trace(wanted, clock, stop); !traced)
        return tl::unexpected(traced.error());
    for (const std::size_t i : again)
        for (auto s = wanted.upper_bound(strips_[i].left_s());
             s != wanted.end() && *s < strips_[i].right_s(); ++s)
            strips_[i].supply(*curve_at_.at(*s));
    if (!new_seeds.empty()) {
        seeds_.insert(new_seeds.begin(), new_seeds.end());
        std::vector<double> marks;
        for (const std::size_t i : again)
            marks.push_back(strips_[i].left_s());
        marks.insert(marks.end(), new_seeds.begin(), new_seeds.end());
        std::sort(marks.begin(), marks.end());
        cut_at(new_seeds);
        again.clear();
        for (std::size_t i = 0; i < strips_.size(); ++i)
            if (std::binary_search(marks.begin(), marks.end(), strips_[i].left_s()))
                again.push_back(i);
    }
    return again;
}

std::vector<const SeededCurve*> Sheet::columns() const {
    std::vector<const SeededCurve*> all;
    for (const double s : seeds_)
        all.push_back(curve_at_.at(s));
    for (const Strip& strip : strips_)
        for (std::size_t c = 2; c < strip.columns().size(); ++c)
            all.push_back(strip.columns()[c].curve);
    return all;
}

} // namespace wakesurf::core
