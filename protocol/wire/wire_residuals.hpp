// From the true values of vertices to residuals and back: predict, take the difference in steps of the
// tolerance, continue from the decoder's value. The sender chooses the predictors. protocol/wire/FORMAT.md,
// Points. Twin of the way back: web-client/src/protocol/wirePoints.ts.
#pragma once

#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_edit.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// The predictors, in integers, the same for encoders and decoders. protocol/wire/FORMAT.md, Points. Twin:
/// web-client/src/protocol/wirePoints.ts.
/// The vertices that a block of points codes.
enum class PointKind : std::uint8_t { Moved, Added };

inline constexpr std::array<std::uint8_t, 2> predictors_of_kind{4, 6};
/// The predictor of changes of added vertices: the mean of those of two neighbours.
inline constexpr int change_predictor = 4;

/// Holds the three components of positions, or one code: the part of a draft that predictors see.
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

/// Holds the changes of added vertices.
struct ChangeSeries {
    static constexpr std::size_t components = 3;
    static constexpr std::int32_t most = 1 << 20;
    LatticePoint* changed;

    std::int32_t at(std::uint32_t v, std::size_t k) const { return changed[v][k]; }

    std::int32_t at_before(std::uint32_t v, std::size_t k) const { return changed[v][k]; }

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
    else if (predictor == 2)
        change =
            x.last_change(v, k) +
            ((x.change(a, k) - x.last_change(a, k) + x.change(b, k) - x.last_change(b, k)) >> 1);
    else if (predictor == 3 && near.opposite != core::no_vertex)
        change = x.change(near.beside, k) + x.change(near.beside2, k) - x.change(near.opposite, k);
    else
        change = (x.change(a, k) + x.change(b, k)) >> 1;
    return x.at_before(v, k) + change;
}

/// Names the vertices that predict an added one: x(p) + x(q) - x(o), or without o the mean of x(p) and x(q).
struct Corner {
    std::uint32_t p, q, o;
    bool before = false; ///< x0 in place of x
};

/// REQUIRES: v > 0.
inline Corner
corner_of(int predictor, std::span<const Neighbours> all, std::uint32_t v, std::uint32_t stay) {
    const Neighbours& near = all[v];
    const std::uint32_t a = near.highest;
    const std::uint32_t b = near.lowest;
    constexpr auto none = core::no_vertex;
    if (a == none)
        return {v - 1, v - 1, none};
    switch (predictor) {
    case 1:
        return {b, b, none};
    case 2:
        return {a, a, all[a].highest};
    case 3:
        if (near.beside != none)
            return {near.beside, near.beside2, near.opposite};
        break;
    case 4:
        return {a, b, none};
    case 5:
        if (b < stay)
            return {b, b, none, true};
        break;
    default:
        break;
    }
    return {a, a, none};
}

template <class Series>
std::int32_t predicted_addition(const Series& x, const Corner& corner, std::size_t k) {
    if (corner.before)
        return x.at_before(corner.p, k);
    const std::int32_t sum = x.at(corner.p, k) + x.at(corner.q, k);
    return corner.o == core::no_vertex ? sum >> 1 : sum - x.at(corner.o, k);
}

/// Calls each(index in `coded`, v, component, prediction) for one vertex after the other; `each` sets the
/// value before the next call.
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
    default:
        return run(std::integral_constant<int, 3>());
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
        const std::uint32_t v = coded[i];
        const Corner corner = v > 0 ? corner_of(predictor, all, v, stay) : Corner{};
        for (std::size_t k = 0; k < Series::components; ++k)
            each(i, v, k, v > 0 ? predicted_addition(x, corner, k) : 0);
    }
}

/// Describes how vertices of one kind are predicted and rounded: [0] their position, then each attribute.
struct PointCoding {
    PointKind kind = PointKind::Moved;
    std::uint8_t attributes = 0;
    std::array<std::uint8_t, max_attributes + 1> predictor{};
    std::array<std::uint16_t, max_attributes + 1> tolerance{};

    bool operator==(const PointCoding&) const = default;
};

struct Residuals {
    PointCoding coding;
    std::uint32_t count = 0;
    std::vector<std::int32_t> position; ///< three a vertex
    std::vector<std::vector<std::int32_t>> codes;
    /// The changes of added vertices, three numbers each.
    std::vector<std::int32_t> change;

    bool operator==(const Residuals&) const = default;
};

/// Returns the predictors that seem best for vertices `coded` of the draft, tried on some of them, whose
/// values in the draft it overwrites. Tolerances are taken from `coding`.
PointCoding choose_predictors(WireDraft& draft,
                              const WireMesh& truth,
                              PointCoding coding,
                              std::span<const std::uint32_t> coded);

/// Fills in vertices `coded` of the draft and returns the residuals from which the decoder does the same. If
/// the truth has no changes, added vertices get the predicted ones.
Residuals make_residuals(WireDraft& draft,
                         const WireMesh& truth,
                         const PointCoding& coding,
                         std::span<const std::uint32_t> coded);

/// Fills in vertices `coded` of the draft from their residuals, as many.
void apply_residuals(WireDraft& draft,
                     const Residuals& residuals,
                     std::span<const std::uint32_t> coded);

} // namespace wakesurf::protocol
