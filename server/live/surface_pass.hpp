// One pass over a surface: its quality and its time.
#pragma once

#include "protocol/wire/mesh_frame.hpp"

#include <cstdint>
#include <optional>

namespace wakesurf::server {

using protocol::Phase;

struct SurfacePass {
    Phase phase = Phase::Final;
    std::uint64_t quads = 0;    ///< the budget of a coarse or refined pass
    std::optional<double> time; ///< of the session's clock; empty: at the end
    double separation = 0.0;    ///< the least of such a pass
};

} // namespace wakesurf::server
