// What is wrong with bytes that no server of ours wrote so: the error of what reads frames.
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
