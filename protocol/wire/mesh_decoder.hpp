// From frames back to states: the client's half of the wire, for tests, scripts and golden files. The server
// itself never decodes what a client sent. Twin: web-client/src/protocol/meshDecoder.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_mesh.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace wakesurf::protocol {

/// Holds a whole update, decoded.
struct DecodedState {
    FrameHeader header; ///< of its last frame: surface, epoch, seq, phase, state_sum ...
    std::shared_ptr<const WireMesh> mesh; ///< never null
};

/// Folds the frames of one surface, in order, into its states. Keeps the newest whole state through errors.
/// Not thread-safe; one decoder a surface.
class MeshDecoder {
  public:
    MeshDecoder();
    ~MeshDecoder();
    MeshDecoder(MeshDecoder&&) noexcept;
    MeshDecoder& operator=(MeshDecoder&&) noexcept;

    /// Returns true if the frame completed a state, which is then newest(). Error: Unsupported, OverLimit or
    /// Corrupt; then only frame 0 of a KEY is accepted (see needs_key). Cost: for a state's last frame
    /// O(state), for the others O(frame).
    core::Result<bool> fold(std::span<const std::byte> frame);

    /// Returns the newest whole state; empty before the first.
    const std::optional<DecodedState>& newest() const { return newest_; }

    /// Says that only a KEY is of use: no state has arrived, or an error occurred.
    bool needs_key() const { return !intact_; }

  private:
    struct Update;

    core::Result<void> check_order(const FrameHeader& header) const;
    core::Result<bool> take(const MeshFrame& frame);

    std::optional<DecodedState> newest_;
    std::unique_ptr<Update> update_; ///< the unfinished one
    bool intact_ = false;
};

} // namespace wakesurf::protocol
