// One particle's view of a field: fields in which finding a place is expensive offer a cursor that starts
// where the particle was last. Each particle and curve takes one, without a hint, so that none depends on
// another. A field some of whose values may not be in memory yet has a view for each thread, which notes
// missing values: results that used them are discarded and recomputed once they are there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::core {

template <class Field>
concept FieldWithCursor = requires(const Field& field) {
    field.cursor();
};

/// A copy is a view of its own. missed(): the view has met something missing since the last take_missed().
template <class Field>
concept PagedField = requires(const Field& field) {
    field.missed();
    field.take_missed();
};

/// A copy of a paged field; the field itself where it has no cursor.
template <class Field>
decltype(auto) cursor_of(const Field& field) {
    if constexpr (FieldWithCursor<Field>)
        return field.cursor();
    else if constexpr (PagedField<Field>)
        return Field(field);
    else
        return (field);
}

template <class View>
bool missed(const View& view) {
    if constexpr (PagedField<View>)
        return view.missed();
    else
        return false;
}

template <class View>
bool take_missed(const View& view) {
    if constexpr (PagedField<View>)
        return view.take_missed();
    else
        return false;
}

/// A view goes on to particle i. @param cell  empty, or where each may be
template <class View>
void restart(const View& view, std::span<std::uint32_t> cell, std::size_t i) {
    if constexpr (requires { view.restart(); }) {
        if (cell.empty())
            view.restart();
        else
            view.restart(cell[i]);
    }
}

/// Keeps where the view has left particle i.
template <class View>
void keep_cell(const View& view, std::span<std::uint32_t> cell, std::size_t i) {
    if constexpr (requires { view.place(); })
        if (!cell.empty())
            cell[i] = view.place().cell();
}

} // namespace wakesurf::core
