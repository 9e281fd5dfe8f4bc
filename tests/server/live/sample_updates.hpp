// Synthetic updates of a ring: small frames whose bytes identify their update.
#pragma once

#include "server/live/update_ring.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>

namespace wakesurf::server {

struct MadeUp {
    std::uint32_t epoch = 1;
    std::uint32_t seq = 0;
    bool key = false;
    std::size_t frames = 1;
    std::size_t bytes = 3; ///< of each frame, at least 3
};

inline SharedUpdate make_update(const MadeUp& what) {
    auto update = std::make_shared<Update>();
    protocol::EncodedUpdate& wire = update->wire;
    wire.epoch = what.epoch;
    wire.seq = what.seq;
    wire.key = what.key;
    wire.base_seq = what.key ? what.seq : what.seq - 1;
    for (std::size_t i = 0; i < what.frames; ++i) {
        std::vector<std::byte> frame(what.bytes);
        frame[0] = static_cast<std::byte>(what.seq);
        frame[1] = static_cast<std::byte>(i);
        frame[2] = static_cast<std::byte>(what.key ? 1 : 0);
        wire.frames.push_back(std::make_shared<const std::vector<std::byte>>(std::move(frame)));
    }
    wire.bytes = what.frames * what.bytes;
    return update;
}

/// The identity of such a frame.
struct Seen {
    int seq = -1; ///< -1: there was no frame
    int frame = -1;
    bool key = false;

    bool operator==(const Seen&) const = default;
};

inline Seen seen(const std::shared_ptr<const std::vector<std::byte>>& frame) {
    if (!frame)
        return {};
    return {std::to_integer<int>((*frame)[0]), std::to_integer<int>((*frame)[1]),
            (*frame)[2] == std::byte{1}};
}

} // namespace wakesurf::server
