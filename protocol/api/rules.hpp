// What the generated rules on parameters beside each other are written with.
#pragma once

#include "core/base/result.hpp"

#include <cmath>
#include <string>

namespace wakesurf::protocol {

inline core::Result<void> wrong(const std::string& message, const std::string& hint) {
    return core::fail(core::Error::Code::InvalidArgument, message, hint);
}

/// After `first` on the way to `last`, which may be the earlier one, and not beyond it.
inline bool between(double value, double first, double last) {
    const double way = value - first;
    return way * (last - first) > 0.0 && std::abs(way) <= std::abs(last - first);
}

} // namespace wakesurf::protocol
