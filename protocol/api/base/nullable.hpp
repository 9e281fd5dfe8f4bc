// A parameter of which null says something else than leaving it out.
#pragma once

#include <optional>

namespace wakesurf::protocol {

/// Given without a value: null.
template <class T>
struct Nullable {
    bool given = false;
    std::optional<T> value;

    bool operator==(const Nullable&) const = default;
};

} // namespace wakesurf::protocol
