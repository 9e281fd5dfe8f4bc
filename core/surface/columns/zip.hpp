// Joins two neighbouring columns into quads, one at a time: each quad takes one or two segments of either
// side, so that its front edge stays about square to the flow however the sides shear. A side of two segments
// gets a mid node. Source: the ribbon advance of Hultquist 1992, on quads as in McLoughlin, Laramee, Zhang,
// CGI 2009.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/columns/column.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace wakesurf::core {

struct ZipRules {
    const Flow* flow;
    double separation;    ///< longest front edge
    bool obstacle = true; ///< false: the flow has none, so no front can cross one
};

/// The front of a strip: vertex `left` of its left column, `right` of its right one.
struct StripFront {
    std::size_t left = 0;
    std::size_t right = 0;

    bool operator==(const StripFront&) const = default;
};

enum class ZipMode {
    ToBothEnds, ///< keep so many segments on either side that both columns can be used up exactly
    Free        ///< stop where one column ends: for strips that end in a tear
};

/// The number of segments of either column in the next quad; empty if every choice would make a front edge
/// longer than the separation, cross an obstacle, or leave a side that no later quad can use up.
struct ZipStep {
    std::size_t left = 1;
    std::size_t right = 1;
};

/// @param left, right  vertices of the columns
std::optional<ZipStep> next_quad(const ZipRules& rules,
                                 std::span<const Vec3> left,
                                 std::span<const Vec3> right,
                                 StripFront front,
                                 ZipMode mode);

/// True when `a` and `b` segments can be joined by quads of one or two segments a side.
constexpr bool joinable(std::size_t a, std::size_t b) {
    return a <= 2 * b && b <= 2 * a;
}

/// Returns the width of the strip at its front, square to the columns.
double front_width(const Column& left, const Column& right, StripFront front);

} // namespace wakesurf::core
