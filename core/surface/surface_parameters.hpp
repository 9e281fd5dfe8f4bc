// What a surface is asked to be: the parameters of `wakesurf surface` and `surface.set`.
#pragma once

#include <cstdint>

namespace wakesurf::core {

enum class SurfaceKind { Stream, Path, Streak, Time };
enum class Direction { Forward, Backward, Both };
enum class Accuracy { Fast, Balanced, Exact };

struct SurfaceParameters {
    SurfaceKind kind = SurfaceKind::Stream;
    double from = 0.0; ///< stream: time at which the field is frozen; path: release time
    double to = 1.0;   ///< shown until; `to - from` is the integration time
    Direction direction = Direction::Forward;
    double separation =
        0.0; ///< longest edge allowed, in the dataset's length unit; 0: DatasetInfo::finest_spacing
    Accuracy accuracy = Accuracy::Balanced;
    std::uint64_t max_quads = 1'000'000;
    bool deformation = false; ///< compute the deformation array (four more samples a step)

    bool operator==(const SurfaceParameters&) const = default;
};

} // namespace wakesurf::core
