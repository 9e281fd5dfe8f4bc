// The options of a sheet: one direction of a stream or path surface.
#pragma once

#include "core/integrate/curve.hpp"

#include <cstdint>

namespace wakesurf::core {

struct SheetOptions {
    TraceOptions trace;
    double release;  ///< simulation time the particles leave the rake
    double duration; ///< signed
    double separation;
    std::uint64_t max_quads;
    double merge = 0.0;   ///< SurfaceParameters::merge
    double angle = 180.0; ///< SurfaceParameters::angle
};

} // namespace wakesurf::core
