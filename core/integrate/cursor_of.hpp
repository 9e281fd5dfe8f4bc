// One particle's view of a field: fields in which finding a place costs something offer a cursor that starts where the
// particle was last. Particles and curves take one each, without a hint, so that none depends on another.
#pragma once

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

/// A view goes on to another particle.
template <class View>
void restart(const View& view) {
    if constexpr (requires { view.restart(); })
        view.restart();
}

} // namespace wakesurf::core
