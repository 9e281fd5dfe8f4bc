// What lists of records are called, in snapshots, files and messages.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Returns what lists of a type of record are called: `rakes`; of `lines`, `lines`.
inline std::string plural_of(std::string_view type) {
    return std::string(type) + (type.ends_with('s') ? "" : "s");
}

} // namespace wakesurf::protocol
