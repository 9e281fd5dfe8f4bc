// From a surface, state after state, to the updates that carry it: matches ids, predicts, quantises, encodes
// once for all clients. The last stage of a datum's path before the socket.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/lattice.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/wire_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace wakesurf::protocol {

/// The check before Draco, whose encoder hangs on a NaN, aborts on an infinity and takes gigabytes for an
/// outlier.
/// Checks that a mesh may be encoded: every position finite and on the lattice, every cell's vertices
/// present, and with `attributes` a finite speed, s and t for each vertex. Error: InvalidArgument for the
/// lattice, OutOfDomain for positions and Corrupt for the rest, stating the count and the first. Cost:
/// O(vertices + cells).
core::Result<void>
guard_mesh(const core::QuadComplex& mesh, const Lattice& lattice, bool attributes);

/// Bounds the errors of a state, in lattice units and in codes. At most 32767.
struct Tolerance {
    std::uint16_t position = 0;  ///< lattice units
    std::uint16_t speed = 0;     ///< and fields
    std::uint16_t parameter = 0; ///< s and t

    /// Says that no errors are allowed.
    bool exact() const { return position == 0 && speed == 0 && parameter == 0; }
};

inline constexpr Tolerance exact_tolerance{};
/// The tolerance of live updates. On a 16 bit lattice the error is that of rounding positions to 14 bits, the
/// speed and fields to 8 bits, s and t to 11 bits.
inline constexpr Tolerance live_tolerance{2, 128, 16};

/// The memory that encoding takes besides the mesh, in bytes a vertex.
inline constexpr std::size_t encoding_bytes = 400;

inline constexpr std::size_t max_fields = max_attributes - surface_attributes.size();

/// Says how good an update is.
struct UpdateOptions {
    Phase phase = Phase::Final;            ///< sent to clients
    Tolerance tolerance = exact_tolerance; ///< errors the state may keep
    /// The ids have nothing to do with those of the mesh before: the update is a KEY.
    bool unrelated = false;
};

/// An update, to be sent to every client with the state of `base_seq`, or to any client if it is a key.
/// Immutable.
struct EncodedUpdate {
    std::uint32_t epoch = 0;               ///< of the stream
    std::uint32_t base_seq = 0;            ///< the state it starts from, unless it is a key
    std::uint32_t seq = 0;                 ///< the state it leads to
    bool key = false;                      ///< it starts from nothing
    Phase phase = Phase::Final;            ///< as it was asked for
    bool lossless = false;                 ///< the state is the surface, exact on the lattice
    SharedFrames frames;                   ///< at least one
    std::size_t bytes = 0;                 ///< of all frames
    std::uint32_t state_sum = 0;           ///< checksum of the state
    std::shared_ptr<const WireMesh> state; ///< it leads to; never null
};

/// Makes the updates of one surface in one epoch, from its first state on. Thread safety: one thread at a
/// time. Frames are encoded in parallel in the caller's oneTBB arena; the bytes do not depend on the number
/// of threads.
class MeshStream {
  public:
    /// @param surface     number in the header of each frame: the subscription
    /// @param attributes  send speed, s and t, and fields; without, only positions and cells
    MeshStream(std::uint32_t surface,
               std::uint32_t epoch,
               Lattice lattice,
               bool attributes = true,
               std::uint32_t first_seq = 0);
    ~MeshStream();
    MeshStream(MeshStream&&) noexcept;
    MeshStream& operator=(MeshStream&&) noexcept;

    /// Returns the update from the mesh of the last call to this one. It is a KEY the first time, when little
    /// of the mesh stays and when an attribute leaves its range. Ids may come in any order: also going back
    /// in time is a delta. Error: as guard_mesh; OverLimit for more than max_mesh_vertices vertices,
    /// max_mesh_cells cells or max_fields fields; Corrupt for ids that do not ascend, and for other fields
    /// than before. After an error the stream is as before.
    /// @param fields  as many in each call
    core::Result<EncodedUpdate>
    next(const core::KeyedMesh& mesh, const UpdateOptions& options, const MeshFields& fields = {});

    /// Returns the state of all clients after the last update; never null.
    std::shared_ptr<const WireMesh> state() const;

    /// Returns the memory of the state and of its index by ids.
    std::size_t bytes() const;

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

/// Returns a KEY of a state that a stream made, for clients that join late or have fallen behind. They then
/// follow the deltas based on it like all others. `update` is the one that led to the state; its frames are
/// not read. Error: OverLimit. Thread safety: concurrent calls are allowed.
core::Result<EncodedUpdate> encode_key(std::uint32_t surface, const EncodedUpdate& update);

/// Returns a mesh whose ids are its indices. One continues another (see MeshStream::next) if it has the
/// vertices and cells of that one, in the same order, and more.
core::KeyedMesh with_ids(core::QuadComplex mesh, double time = 0.0);

} // namespace wakesurf::protocol
