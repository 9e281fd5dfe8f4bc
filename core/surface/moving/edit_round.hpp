// Edits of a moving surface that are wanted at the same time, made in parallel: each that meets none before it, in the caller's
// order, of those that are made; the others are asked again. Which those are follows from the mesh, whatever the number of
// threads.
// Source: Blelloch, Fineman, Shun, Greedy Sequential Maximal Independent Set and Matching Are Parallel on Average, 2012.
#pragma once

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/claims.hpp"
#include "core/surface/moving/material_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

template <class Edit>
struct EditRound {
    std::vector<Edit> made;          ///< in order
    std::vector<std::uint32_t> lost; ///< ranks of those that met one that was made, in order

    /// The numbers of a list that are to be asked again.
    template <class T>
    std::vector<T> again(const std::vector<T>& asked) const {
        std::vector<T> found;
        found.reserve(lost.size());
        for (const std::uint32_t rank : lost)
            found.push_back(asked[rank]);
        return found;
    }
};

/// For edits that take no numbers.
inline constexpr auto numbers_nothing = [](const auto&) { return std::size_t{0}; };
inline constexpr auto prepares_nothing = [](std::size_t) {};

/// A squared length, in squares of the separation, to a millionth: rounding must not decide the order of edges of one length.
/// What is not a number, and has no place in an order, comes with the longest.
inline double rounded_length(double squared) {
    const double its = std::round(1e6 * squared);
    return its >= 0.0 ? its : std::numeric_limits<double>::infinity();
}

/// So many are asked by one thread. Where there are no more, it makes them as well.
inline constexpr std::size_t asked_together = 32;
/// After so many rounds one thread makes what was lost. Few are left then, unless all meet, as round one vertex.
inline constexpr int rounds_together = 12;

/// As edit_round(), in one thread: none is lost.
template <class Edit, class Ask, class Takes, class Prepare, class Make>
EditRound<Edit> one_by_one(std::size_t count,
                           MaterialTriangles& triangles,
                           const Ask& ask,
                           const Takes& takes,
                           const Prepare& prepare,
                           const Make& make) {
    EditRound<Edit> result;
    TriangleChanges changes;
    std::vector<std::uint32_t> claimed;
    std::size_t number = 0;
    for (std::size_t i = 0; i < count; ++i) {
        claimed.clear();
        std::optional<Edit> edit = ask(static_cast<std::uint32_t>(i), claimed);
        if (!edit)
            continue;
        const std::size_t taken = takes(*edit);
        prepare(taken);
        make(*edit, number, changes);
        number += taken;
        result.made.push_back(std::move(*edit));
    }
    triangles.add(changes);
    return result;
}

/// Asks for `count` edits and makes each that meets none made before it: a greedy independent set, found in one pass. Waiting
/// instead for all before it, wanted or made, took 360 rounds to turn every diagonal of 120 by 120 squares.
/// One that is not wanted now is neither made nor lost.
/// @param round    counts from 0 while what was lost is asked again
/// @param triangles  their claims have room for what is claimed
/// @param ask      `optional<Edit> ask(rank, claimed)`. Reads only. Appends to `claimed` all vertices of every triangle that
///                 the edit makes another one of, and one of every other triangle that it asks about. What lies beyond an edge
///                 may be changed by who has claimed its ends. Or else it appends elements that nothing but these edits
///                 changes, and that the edit looks at
/// @param prepare  `prepare(more)`: how many numbers the edits that are made next will take, beside those from 0 on that others have
/// @param make     `make(edit, first, changes)`, in parallel: `edit` takes the numbers from `first` on
/// @param takes    `takes(edit)`: how many numbers
template <class Edit, class Ask, class Takes, class Prepare, class Make>
EditRound<Edit> edit_round(int round,
                           std::size_t count,
                           MaterialTriangles& triangles,
                           const Ask& ask,
                           const Takes& takes,
                           const Prepare& prepare,
                           const Make& make) {
    struct Wanted {
        Edit edit;
        std::uint32_t rank;
        std::size_t end; ///< of what it claims
        bool wins = false;
        std::size_t number = 0; ///< its first
    };

    struct Share {
        std::vector<Wanted> wanted;
        std::vector<std::uint32_t> claimed;
        TriangleChanges changes;
    };

    if (round >= rounds_together || count <= asked_together)
        return one_by_one<Edit>(count, triangles, ask, takes, prepare, make);
    std::vector<Share> shares((count + asked_together - 1) / asked_together);
    const auto each_share = [&](const auto& visit) {
        for_each_index(
            shares.size(), [&](std::size_t s) { visit(shares[s], s); }, 1);
    };
    each_share([&](Share& share, std::size_t s) {
        for (std::size_t i = s * asked_together; i < std::min(count, (s + 1) * asked_together);
             ++i) {
            const std::size_t begin = share.claimed.size();
            const auto rank = static_cast<std::uint32_t>(i);
            if (std::optional<Edit> edit = ask(rank, share.claimed))
                share.wanted.push_back({std::move(*edit), rank, share.claimed.size()});
            else
                share.claimed.resize(begin);
        }
    });
    Claims& claims = triangles.claims();
    claims.begin();
    std::size_t numbers = 0;
    for (Share& share : shares) {
        std::size_t begin = 0;
        for (Wanted& each : share.wanted) {
            each.wins = claims.take(std::span(share.claimed).subspan(begin, each.end - begin));
            begin = each.end;
            each.number = numbers;
            numbers += each.wins ? takes(each.edit) : 0;
        }
    }
    prepare(numbers);
    each_share([&](Share& share, std::size_t) {
        for (const Wanted& each : share.wanted)
            if (each.wins)
                make(each.edit, each.number, share.changes);
    });
    EditRound<Edit> result;
    for (Share& share : shares) {
        triangles.add(share.changes);
        for (Wanted& each : share.wanted)
            if (each.wins)
                result.made.push_back(std::move(each.edit));
            else
                result.lost.push_back(each.rank);
    }
    return result;
}

} // namespace wakesurf::core
