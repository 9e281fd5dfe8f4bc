// What wakesurf_frames.py cannot do by itself: the Draco blocks of mesh frames, behind one function of C. libwakesurf_draco.so.
#include "protocol/wire/draco_points.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

using wakesurf::protocol::Channel;

/// Fills `into` with the values of one channel after the other: `points` times `components[c]` numbers of channel c.
/// Returns 0, or 1 where the block is damaged or not of these points and channels. Thread safety: concurrent calls are fine.
extern "C" [[gnu::visibility("default")]] int wakesurf_draco_decode(const std::byte* block,
                                                                    std::size_t size,
                                                                    std::uint32_t points,
                                                                    std::uint32_t channels,
                                                                    const std::uint8_t* components,
                                                                    std::int32_t* into) noexcept
    try {
    std::vector<Channel<std::int32_t>> all;
    for (const std::uint8_t each : std::span(components, channels)) {
        const std::size_t numbers = std::size_t{points} * each;
        all.push_back({std::span(into, numbers), each});
        into += numbers;
    }
    return wakesurf::protocol::decode_points({block, size}, all, points) ? 0 : 1;

} catch (...) {

    return 1; // no memory
}
