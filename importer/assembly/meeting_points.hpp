// Points at one place whose velocities differ: two fluids with a mesh each in one file, sides of a sheet that slips,
// or only the elements of a discontinuous method and pieces that were averaged each by itself.
#pragma once

#include "importer/assembly/disjoint_sets.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace wakesurf::importer {

/// Holds pairs of points of several pieces at one place, by numbers that count through the blocks.
///
/// Two points are one node unless their velocities differ, at any time-step, by more than a fiftieth of the
/// highest speed and by more than four times what they change by along the edges of cells that lead away from
/// there, in the direction of the jump. A piece of fewer cells than there are pieces is an element of a discontinuous
/// method, at whose faces all values jump: its points are one node with others always.
class MeetingPoints {
  public:
    /// @param same  the lowest point of the same place, of each. @param piece  of each; `cells` of each piece
    MeetingPoints(std::span<const std::uint32_t> same,
                  std::span<const std::uint32_t> piece,
                  const std::vector<std::uint32_t>& cells);
    MeetingPoints() = default;

    bool empty() const { return pairs_.empty(); }

    /// Takes an edge of a cell; all must be given, in whatever order.
    void add_edge(std::uint32_t p, std::uint32_t q);

    /// Takes the velocities of all points at one time-step into account.
    void look_at(std::span<const float> velocity);

    /// Returns true if points that are one node would not be so at a time-step.
    bool tears(std::span<const float> velocity) const;

    /// Joins the points that are one node by all that was looked at.
    void join(DisjointSets& nodes) const;

    /// Forgets pairs that are not one node in `same`.
    void keep_joined(std::span<const std::uint32_t> same);

    /// Returns the largest difference between points that are one node in `same`, or that are not; 0 without a
    /// pair, or where it is a matter of rounding.
    double largest(std::span<const std::uint32_t> same, bool joined) const;

  private:
    struct Pair {
        std::uint32_t a, b;
        bool of_elements; ///< one is of an element
        bool agrees = true;
        float most = 0.0f; ///< by which they differed
    };

    struct Velocities;
    bool agree(const Pair& pair, const Velocities& velocities) const;

    std::vector<Pair> pairs_;
    /// A point of a pair and the other end of an edge there; sorted.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> near_;
    std::vector<bool> wanted_;
    float highest_ = 0.0f; ///< speed
};

} // namespace wakesurf::importer
