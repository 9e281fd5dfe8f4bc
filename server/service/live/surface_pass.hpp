// One pass over a surface: how good it is to be, and of which time.
#pragma once

#include "protocol/wire/mesh_frame.hpp"

#include <cstdint>
#include <optional>

namespace wakesurf::server {

using protocol::Phase;

struct SurfacePass {
    Phase phase = Phase::Final;
    std::uint64_t quads = 0;    ///< most of a coarse or refined pass
    std::optional<double> time; ///< of the session's clock; nothing: at the end
    double separation = 0.0;    ///< of such a pass, at least
};

} // namespace wakesurf::server
