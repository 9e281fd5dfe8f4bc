// The kinds of interpolation between stored times.
#pragma once

#include <cstdint>

namespace wakesurf::core {

/// Stored velocity at a time between two stored ones. Linear: in time, as ParaView shows it. Cubic: at each place
/// from four stored times, with the slopes of parabolas through three. Flow: the same along a straight way
/// through the place, at the part of the fluid's velocity with which what changes is carried.
enum class Between : std::uint8_t { Linear, Cubic, Flow };

} // namespace wakesurf::core
