// Edits of a moving surface that are wanted at the same time, made in parallel: of those that meet, the first in the caller's
// order wins and the others are asked again. Which that is follows from the mesh, whatever the number of threads.
// Source: Blelloch, Fineman, Gibbons, Shun, Internally Deterministic Parallel Algorithms Can Be Fast, 2012.
#pragma once

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/claims.hpp"
#include "core/surface/moving/material_triangles.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace wakesurf::core {

template <class Edit>
struct EditRound {
    std::vector<Edit> made;          ///< in order
    std::vector<std::uint32_t> lost; ///< ranks of those that met an earlier one, in order

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

/// Asks for `count` edits and makes those that meet none before them. One that is not wanted now is neither made nor lost.
/// @param claims   has room for what is claimed
/// @param ask      `optional<Edit> ask(rank, claimed)`. Reads only. Appends to `claimed` all vertices of every triangle that
///                 the edit changes, and one of every other triangle that it asks about; or else elements that nothing but
///                 these edits changes, and that the edit looks at
/// @param prepare  `prepare(number)`: how many numbers the edits that are made will take
/// @param make     `make(edit, first, changes)`, in parallel: `edit` takes the numbers from `first` on
/// @param takes    `takes(edit)`: how many numbers
template <class Edit, class Ask, class Takes, class Prepare, class Make>
EditRound<Edit> edit_round(std::size_t count,
                           MaterialTriangles& triangles,
                           const Ask& ask,
                           const Takes& takes,
                           const Prepare& prepare,
                           const Make& make) {
    constexpr std::size_t asked_together = 32;

    struct Wanted {
        Edit edit;
        std::uint32_t rank;
        std::size_t end; ///< of what it claims
        bool wins = true;
    };

    struct Share {
        std::vector<Wanted> wanted;
        std::vector<std::uint32_t> claimed;
        std::size_t first = 0, taken = 0; ///< numbers
        TriangleChanges changes;
    };

    Claims& claims = triangles.claims();
    std::vector<Share> shares((count + asked_together - 1) / asked_together);
    const auto each_share = [&](const auto& visit) {
        for_each_index(
            shares.size(),
            [&](std::size_t s) {
                if (Share& share = shares[s]; s * asked_together < count)
                    visit(share, s);
            },
            1);
    };
    each_share([&](Share& share, std::size_t s) {
        for (std::size_t i = s * asked_together; i < std::min(count, (s + 1) * asked_together);
             ++i) {
            const std::size_t begin = share.claimed.size();
            const auto rank = static_cast<std::uint32_t>(i);
            if (std::optional<Edit> edit = ask(rank, share.claimed)) {
                for (std::size_t c = begin; c < share.claimed.size(); ++c)
                    claims.claim(share.claimed[c], rank);
                share.wanted.push_back({std::move(*edit), rank, share.claimed.size()});
            } else {
                share.claimed.resize(begin);
            }
        }
    });
    each_share([&](Share& share, std::size_t) {
        std::size_t begin = 0;
        for (Wanted& each : share.wanted) {
            for (; begin < each.end; ++begin)
                each.wins = each.wins && claims.has(share.claimed[begin], each.rank);
            if (each.wins)
                share.taken += takes(each.edit);
        }
    });
    std::size_t numbers = 0;
    for (Share& share : shares) {
        share.first = numbers;
        numbers += share.taken;
    }
    prepare(numbers);
    each_share([&](Share& share, std::size_t) {
        for (const std::uint32_t element : share.claimed)
            claims.release(element);
        std::size_t first = share.first;
        for (const Wanted& each : share.wanted)
            if (each.wins) {
                make(each.edit, first, share.changes);
                first += takes(each.edit);
            }
    });
    EditRound<Edit> round;
    for (Share& share : shares) {
        triangles.add(share.changes);
        for (Wanted& each : share.wanted)
            if (each.wins)
                round.made.push_back(std::move(each.edit));
            else
                round.lost.push_back(each.rank);
    }
    return round;
}

} // namespace wakesurf::core
