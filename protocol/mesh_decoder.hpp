// From frames back to a mesh: the client's half of the wire, for tests, scripts and golden files. The server itself
// never decodes what a client sent. Twin: web-client/src/protocol/meshDecoder.ts.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/lattice.hpp"
#include "protocol/mesh_frame.hpp"
#include "protocol/state_crc.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

struct WireAttribute {
    AttributeRange range;
    std::vector<std::uint16_t> code; ///< one a vertex; range.value(code[i]) is the attribute
};

struct WireMesh {
    std::uint32_t surface = 0;
    std::uint32_t epoch = 0;
    std::uint32_t seq = 0; ///< of the newest frame
    int lattice_bits = 0;
    std::vector<LatticePoint> position;
    std::vector<WireAttribute> attributes;
    std::vector<core::Cell> cells;
    bool complete = false; ///< the last frame of the state is in and its checksum held
    bool final = false;    ///< no finer state of this epoch follows
    std::uint32_t state_crc = 0;
};

/// Folds the frames of one surface, in order, into its mesh.
/// Not thread safe; one decoder a surface.
class MeshDecoder {
  public:
    /// Error: what read_frame and decode_points report; Corrupt when the frame does not follow the one before or the
    /// state's checksum fails. After an error only a frame that starts a new mesh is taken.
    core::Result<void> fold(std::span<const std::byte> frame);

    const WireMesh& mesh() const { return mesh_; }

  private:
    core::Result<void> check_order(const MeshFrame& frame) const;
    core::Result<void> append(const MeshFrame& frame);

    WireMesh mesh_;
    StateCrc crc_;
    bool started_ = false; ///< a mesh has been begun, ever: epochs may only grow from here
    bool intact_ = false;  ///< every frame since the mesh began was taken
};

} // namespace wakesurf::protocol
