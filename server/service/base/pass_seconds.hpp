// The time of one pass over a surface, stage by stage, as reported to clients.
#pragma once

namespace wakesurf::server {

struct PassSeconds {
    double queue = 0.0;   ///< from the request to the beginning
    double load = 0.0;    ///< waiting for time-steps
    double compute = 0.0; ///< all the rest of building
    double encode = 0.0;
};

} // namespace wakesurf::server
