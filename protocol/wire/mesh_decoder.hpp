// From frames back to states: the client's half of the wire, for tests, scripts and golden files. The server itself
// never decodes what a client sent. Twin: web-client/src/protocol/meshDecoder.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_mesh.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace wakesurf::protocol {

/// A whole update, decoded.
struct DecodedState {
    FrameHeader header; ///< of its last frame: surface, epoch, seq, phase, state_sum ...
    std::shared_ptr<const WireMesh> mesh; ///< never null
};

/// Folds the frames of one surface, in order, into its states. Keeps the newest whole state through errors.
/// Not thread safe; one decoder a surface.
class MeshDecoder {
  public:
    MeshDecoder();
    ~MeshDecoder();
    MeshDecoder(MeshDecoder&&) noexcept;
    MeshDecoder& operator=(MeshDecoder&&) noexcept;

    /// True when the frame made a state whole, which is then newest().
    /// Error: Unsupported, OverLimit or Corrupt; then nothing but frame 0 of a KEY is taken (see needs_key).
    /// Cost: of a state's last frame O(state), of the others O(frame).
    core::Result<bool> fold(std::span<const std::byte> frame);

    /// The newest whole state, if there has been one.
    const std::optional<DecodedState>& newest() const { return newest_; }

    /// Deltas are of no use: nothing has come yet, or something went wrong.
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
