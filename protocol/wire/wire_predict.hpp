// The predictors, in integers, the same for those who encode and those who decode. protocol/wire/README.md, Points.
// Twin: web-client/src/protocol/wirePredict.ts.
#pragma once

#include "protocol/wire/wire_draft.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace wakesurf::protocol {

/// Which vertices a block of points codes.
enum class PointKind : std::uint8_t { Moved, Added, Change };

inline constexpr std::array<std::uint8_t, 3> predictors_of_kind{6, 8, 1};

/// Values with the three components of a position, or one code: what the predictors see of a draft.
struct PositionSeries {
    static constexpr std::size_t components = 3;
    LatticePoint* now;          ///< x
    LatticePoint* changed;      ///< d
    const LatticePoint* before; ///< x0, of vertices that stay
    const LatticePoint* last;   ///< h
    std::int32_t highest;       ///< values are 0 .. highest

    std::int32_t at(std::uint32_t v, std::size_t k) const { return now[v][k]; }

    std::int32_t at_before(std::uint32_t v, std::size_t k) const { return before[v][k]; }

    std::int32_t change(std::uint32_t v, std::size_t k) const { return changed[v][k]; }

    std::int32_t last_change(std::uint32_t v, std::size_t k) const { return last[v][k]; }

    void move(std::uint32_t v, std::size_t k, std::int32_t value) const {
        now[v][k] = value;
        changed[v][k] = value - before[v][k];
    }

    void add(std::uint32_t v, std::size_t k, std::int32_t value) const { now[v][k] = value; }

    std::int32_t clamped(std::int32_t value) const { return std::clamp(value, 0, highest); }
};

struct CodeSeries {
    static constexpr std::size_t components = 1;
    std::uint16_t* now;
    const std::uint16_t* before;

    std::int32_t at(std::uint32_t v, std::size_t) const { return now[v]; }

    std::int32_t at_before(std::uint32_t v, std::size_t) const { return before[v]; }

    std::int32_t change(std::uint32_t v, std::size_t) const { return now[v] - before[v]; }

    std::int32_t last_change(std::uint32_t, std::size_t) const { return 0; }

    void move(std::uint32_t v, std::size_t, std::int32_t value) const {
        now[v] = static_cast<std::uint16_t>(value);
    }

    void add(std::uint32_t v, std::size_t k, std::int32_t value) const { move(v, k, value); }

    std::int32_t clamped(std::int32_t value) const { return std::clamp(value, 0, 65535); }
};

/// The changes of a KEY with history.
struct ChangeSeries {
    static constexpr std::size_t components = 3;
    static constexpr std::int32_t most = 1 << 20;
    LatticePoint* changed;

    std::int32_t change(std::uint32_t v, std::size_t k) const { return changed[v][k]; }

    void add(std::uint32_t v, std::size_t k, std::int32_t value) const { changed[v][k] = value; }

    std::int32_t clamped(std::int32_t value) const { return std::clamp(value, -most, most); }
};

inline PositionSeries positions_of(WireDraft& draft) {
    return {draft.after.position.data(), draft.after.change.data(), draft.position_before.data(),
            draft.change_before.data(), (std::int32_t{1} << draft.after.lattice_bits) - 1};
}

inline CodeSeries codes_of(WireDraft& draft, std::size_t attribute) {
    return {draft.after.codes[attribute].data(), draft.codes_before[attribute].data()};
}

inline ChangeSeries changes_of(WireDraft& draft) {
    return {draft.after.change.data()};
}

template <class Series, int predictor>
std::int32_t
predicted_move(const Series& x, const Neighbours& near, std::uint32_t v, std::size_t k) {
    const std::uint32_t a = near.highest;
    const std::uint32_t b = near.lowest;
    std::int32_t change = 0;
    if (predictor == 0 || a == core::no_vertex)
        change = x.last_change(v, k);
    else if (predictor == 1)
        change = x.change(a, k);
    else if (predictor == 3)
        change = x.last_change(v, k) + x.change(a, k) - x.last_change(a, k);
    else if (predictor == 4)
        change =
            x.last_change(v, k) +
            ((x.change(a, k) - x.last_change(a, k) + x.change(b, k) - x.last_change(b, k)) >> 1);
    else if (predictor == 5 && near.opposite != core::no_vertex)
        change = x.change(near.beside, k) + x.change(near.beside2, k) - x.change(near.opposite, k);
    else
        change = (x.change(a, k) + x.change(b, k)) >> 1;
    return x.at_before(v, k) + change;
}

/// The predictor an added vertex really gets: the first of the fallbacks for which it has the neighbours.
inline int possible_predictor(int wanted,
                              const Neighbours& near,
                              std::span<const Neighbours> all,
                              std::uint32_t stay) {
    constexpr auto none = core::no_vertex;
    if (near.highest == none)
        return -1;
    const Neighbours& lowest = all[near.lowest];
    const Neighbours& highest = all[near.highest];
    if (wanted == 5 &&
        (lowest.lowest == none || highest.lowest == none || all[highest.lowest].lowest == none))
        wanted = 4;
    if (wanted == 4 && near.beside == none)
        wanted = 2;
    if (wanted == 2 && highest.highest == none)
        wanted = 0;
    if ((wanted == 3 && lowest.lowest == none) || (wanted == 7 && near.lowest >= stay))
        wanted = 1;
    return wanted;
}

template <class Series>
std::int32_t predicted_addition(const Series& x,
                                int predictor,
                                std::span<const Neighbours> all,
                                std::uint32_t v,
                                std::size_t k) {
    const Neighbours& near = all[v];
    const std::uint32_t a = near.highest;
    const std::uint32_t b = near.lowest;
    switch (predictor) {
    case 0:
        return x.at(a, k);
    case 1:
        return x.at(b, k);
    case 2:
        return 2 * x.at(a, k) - x.at(all[a].highest, k);
    case 3:
        return 2 * x.at(b, k) - x.at(all[b].lowest, k);
    case 4: {
        const std::int32_t sum = x.at(near.beside, k) + x.at(near.beside2, k);
        return near.opposite == core::no_vertex ? sum >> 1 : sum - x.at(near.opposite, k);
    }
    case 5:
        return 2 * x.at(b, k) - x.at(all[b].lowest, k) + x.at(a, k) - 2 * x.at(all[a].lowest, k) +
               x.at(all[all[a].lowest].lowest, k);
    case 6:
        return (x.at(a, k) + x.at(b, k)) >> 1;
    case 7:
        return x.at_before(b, k);
    default:
        return v > 0 ? x.at(v - 1, k) : 0;
    }
}

/// Calls each(index in `coded`, v, component, prediction) for one vertex after the other; `each` settles the value before the
/// next one is asked for.
template <class Series, class Each>
void predict_moved(const Series& x,
                   int predictor,
                   std::span<const Neighbours> all,
                   std::span<const std::uint32_t> coded,
                   Each each) {
    const auto run = [&]<int p>(std::integral_constant<int, p>) {
        for (std::size_t i = 0; i < coded.size(); ++i)
            for (std::size_t k = 0; k < Series::components; ++k)
                each(i, coded[i], k, predicted_move<Series, p>(x, all[coded[i]], coded[i], k));
    };
    switch (predictor) {
    case 0:
        return run(std::integral_constant<int, 0>());
    case 1:
        return run(std::integral_constant<int, 1>());
    case 2:
        return run(std::integral_constant<int, 2>());
    case 3:
        return run(std::integral_constant<int, 3>());
    case 4:
        return run(std::integral_constant<int, 4>());
    default:
        return run(std::integral_constant<int, 5>());
    }
}

template <class Series, class Each>
void predict_added(const Series& x,
                   int predictor,
                   std::span<const Neighbours> all,
                   std::uint32_t stay,
                   std::span<const std::uint32_t> coded,
                   Each each) {
    for (std::size_t i = 0; i < coded.size(); ++i) {
        const int possible = possible_predictor(predictor, all[coded[i]], all, stay);
        for (std::size_t k = 0; k < Series::components; ++k)
            each(i, coded[i], k, predicted_addition(x, possible, all, coded[i], k));
    }
}

template <class Each>
void predict_changes(const ChangeSeries& x,
                     std::span<const Neighbours> all,
                     std::span<const std::uint32_t> coded,
                     Each each) {
    for (std::size_t i = 0; i < coded.size(); ++i) {
        const Neighbours& near = all[coded[i]];
        for (std::size_t k = 0; k < ChangeSeries::components; ++k)
            each(i, coded[i], k,
                 near.highest == core::no_vertex
                     ? 0
                     : (x.change(near.highest, k) + x.change(near.lowest, k)) >> 1);
    }
}

} // namespace wakesurf::protocol
