// One whole mesh as the frames of a KEY, for meshes without history such as an obstacle.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/wire/mesh_stream.hpp"

#include <cstdint>
#include <string>

namespace wakesurf::protocol {

struct EncodeOptions {
    std::uint32_t surface = 0; ///< number in the header of each frame
    std::uint32_t epoch = 0;
    std::uint32_t seq = 0;
    bool final = false; ///< else coarse
    /// Sends speed, s and t, and fields; if false, the mesh needs only positions and cells.
    bool attributes = true;
    double time = 0.0;
};

struct EncodedState {
    SharedFrames frames; ///< at least one
    std::uint32_t state_sum = 0;
};

/// Encodes a mesh as update `seq`. A mesh without cells becomes a state without vertices.
/// Error, thread safety: as MeshStream::next.
core::Result<EncodedState> encode_state(const core::QuadComplex& mesh,
                                        const Lattice& lattice,
                                        const EncodeOptions& options,
                                        const MeshFields& fields = {});

/// Appends the frames, each preceded by its length as u32: so they stand in files.
void append_with_lengths(std::string& out, const SharedFrames& frames);

} // namespace wakesurf::protocol
