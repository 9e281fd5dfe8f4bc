// The error for bytes that no server of ours wrote.
#pragma once

#include "core/base/result.hpp"

#include <string>
#include <utility>

namespace wakesurf::protocol {

inline tl::unexpected<core::Error> corrupt(std::string message) {
    return core::fail(core::Error::Code::Corrupt, std::move(message),
                      "subscribe to the surface again");
}

} // namespace wakesurf::protocol
