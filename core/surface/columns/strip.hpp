// A strip: what lies between two neighbouring seeds of the rake. Where it grows wider than the separation it
// splits in two at a column traced from the rake, again and again: a binary tree over the seed parameter. The
// tree is refined in rounds: zip the strip, see where it fails, ask for columns there, zip again. Every
// decision is local to the strip, so strips are built in parallel and the result does not depend on the
// order.
#pragma once

#include "core/surface/columns/zip.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

/// A traced curve and the seed parameter it starts from.
struct SeededCurve {
    double s = 0.0;
    Curve curve;
    Column column; ///< from the rake on; made only where a strip ends at the curve
};

struct StripLimits {
    ZipRules rules;
    ColumnSpacing spacing;
    double least_width;    ///< a narrower strip that still diverges is a tear, not a divergence
    double least_interval; ///< seed parameter distance below which the surface is discontinuous
};

/// A vertex of a strip: which of its columns, and which vertex of that column.
struct StripVertex {
    std::uint32_t column = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t index = 0;

    bool exists() const { return column != std::numeric_limits<std::uint32_t>::max(); }
};

struct StripCell {
    std::array<StripVertex, 4> corner;
    std::array<StripVertex, 4> mid;
};

struct StripColumn {
    const SeededCurve* curve;
    const Column* column;
    int depth; ///< splits of the strip it took to get this column; 0: an end of the strip
};

class Strip {
  public:
    static constexpr std::uint32_t left_column = 0, right_column = 1;

    /// @param left, right  curves at both ends, owned by the caller and stable
    /// @param right_s      seed parameter of the right end: 1 where a closed rake's last strip meets its
    ///                     first column
    Strip(const SeededCurve& left, const SeededCurve& right, double right_s);
    Strip(const Strip&) = delete;
    Strip(Strip&&) = default;
    Strip& operator=(Strip&&) = default;

    /// Zips what the tree's changes since the last call concern. Thread safety: disjoint strips concurrently.
    void zip(const StripLimits& limits);

    /// The demand of the last zip(). `middles` are seed parameters of curves needed; `new_seed`: the strip
    /// already diverges at the rake and must be cut there into two strips.
    struct Demand {
        std::vector<double> middles;
        std::optional<double> new_seed;
        bool changed = false; ///< the tree changed: zip() again once the curves are there
    };

    Demand refine(const StripLimits& limits);

    static constexpr std::uint32_t no_row = std::numeric_limits<std::uint32_t>::max();

    /// Returns the number of nodes of the tree; node 0 is its root. Some may be out of use.
    std::size_t nodes() const { return nodes_.size(); }

    /// A node's own, younger ones first; older ones are its children's.
    std::span<const StripCell> cells(std::int32_t node) const {
        return nodes_[static_cast<std::size_t>(node)].cells;
    }

    /// The left (0) or the right (1) child of a node, -1 where it does not split.
    std::int32_t child(std::int32_t node, std::size_t side) const {
        const Node& here = nodes_[static_cast<std::size_t>(node)];
        return here.split ? here.child[side] : -1;
    }

    /// Splits nodes at rows that bend, where the middle column can begin there; else leaves them as they are.
    /// @param rows  by node: the row, or no_row
    Demand split_bends(const StripLimits& limits, std::span<const std::uint32_t> rows);

    /// Hands over the curve for a seed parameter refine() asked for. Must outlive the strip.
    void supply(const SeededCurve& curve);

    /// Accepts what cannot be zipped as torn: used when rounds or the budget run out.
    void tear_rest();

    double left_s() const { return nodes_.front().left_s; }

    double right_s() const { return nodes_.front().right_s; }

    /// The two ends, then those inserted between, in no particular order.
    const std::vector<StripColumn>& columns() const { return columns_; }

    std::size_t quads() const { return quads_; }

    /// Calls visit(const StripCell&) for every quad, younger ones of a column first.
    template <class Visit>
    void for_each_cell(const Visit& visit) const {
        visit_cells(0, visit);
    }

    /// Calls visit(std::uint32_t column) for the inserted columns from left to right.
    template <class Visit>
    void for_each_inner_column(const Visit& visit) const {
        visit_columns(0, visit);
    }

  private:
    static constexpr std::uint32_t no_column = std::numeric_limits<std::uint32_t>::max();

    struct Node {
        double left_s, right_s;
        const SeededCurve* middle = nullptr;
        bool wants_middle = false;
        std::uint32_t rows = 0; ///< quads before the split at `middle`
        std::uint32_t drop = 1; ///< quads the next lowering moves the split
        std::int32_t parent = -1;
        std::int32_t child[2] = {-1, -1};
        std::int32_t depth = 0;
        bool torn = false;
        bool bent = false; ///< split because the sheet bends: not needed
        bool flat = false; ///< is not split for bending, since the middle column cannot begin there

        // Name what was zipped last, and what it was made from: quads stay while that stays the same.
        std::uint32_t left = no_column, right = no_column;
        StripFront start;
        bool free = false;
        StripFront front; ///< after all of `cells`
        std::vector<StripCell> cells;
        std::uint32_t column = no_column; ///< of `middle`
        std::uint32_t left_version = 0, right_version = 0;
        bool split = false; ///< `column` starts at `front`
    };

    struct Failure {
        std::int32_t node;
        std::uint32_t rows; ///< quads made before it
        double width;       ///< of the front there
        bool exhausted;     ///< a column ended, rather than an edge too long
        bool middle_too_short;
    };

    void zip_node(const StripLimits& limits,
                  std::int32_t node,
                  std::uint32_t left,
                  std::uint32_t right,
                  StripFront front);
    bool extend(const StripLimits& limits, Node& node, std::uint32_t rows);
    bool place_middle(const StripLimits& limits, Node& node);
    void lower(std::int32_t node, Demand& demand);
    void branch(std::int32_t node, std::uint32_t rows, Demand& demand);
    void split_bend(std::int32_t node, std::uint32_t row, Demand& demand);

    double middle_s(const Node& node) const { return 0.5 * (node.left_s + node.right_s); }

    template <class Visit>
    void visit_cells(std::int32_t node, const Visit& visit) const {
        const Node& here = nodes_[static_cast<std::size_t>(node)];
        for (const StripCell& cell : here.cells)
            visit(cell);
        if (!here.split)
            return;
        visit_cells(here.child[0], visit);
        visit_cells(here.child[1], visit);
    }

    template <class Visit>
    void visit_columns(std::int32_t node, const Visit& visit) const {
        const Node& here = nodes_[static_cast<std::size_t>(node)];
        if (!here.split)
            return;
        visit_columns(here.child[0], visit);
        visit(here.column);
        visit_columns(here.child[1], visit);
    }

    std::vector<Node> nodes_;
    std::vector<StripColumn> columns_;
    std::vector<std::unique_ptr<Column>> inner_; ///< what columns_ points to, from the third on
    std::vector<std::uint32_t> version_; ///< by column: counts how often its vertices became others
    std::vector<Failure> failures_;
    std::size_t quads_ = 0;
};

} // namespace wakesurf::core
