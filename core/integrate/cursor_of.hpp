// One particle's view of a field: fields in which finding a place costs something offer a cursor that starts where the
// particle was last. Particles and curves take one each, without a hint, so that none depends on another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::core {

template <class Field>
concept FieldWithCursor = requires(const Field& field) {
    field.cursor();
};

/// The field itself where it has no cursor.
template <class Field>
decltype(auto) cursor_of(const Field& field) {
    if constexpr (FieldWithCursor<Field>)
        return field.cursor();
    else
        return (field);
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
