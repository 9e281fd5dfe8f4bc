// What one pass over a surface took, stage by stage: what its clients are told.
#pragma once

namespace wakesurf::server {

struct PassSeconds {
    double queue = 0.0;   ///< from when it was wanted until it began
    double load = 0.0;    ///< waiting for time-steps
    double compute = 0.0; ///< all the rest of building
    double encode = 0.0;
};

} // namespace wakesurf::server
