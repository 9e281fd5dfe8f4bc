#include "protocol/wire/mesh_encoder.hpp"

#include <utility>

namespace wakesurf::protocol {

core::Result<EncodedState> encode_state(const core::QuadComplex& mesh,
                                        const Lattice& lattice,
                                        const EncodeOptions& options,
                                        const MeshFields& fields) {
    MeshStream stream(options.surface, options.epoch, lattice, options.attributes, options.seq);
    UpdateOptions update;
    update.phase = options.final ? Phase::Final : Phase::Coarse;
    return stream.next(with_ids(mesh, options.time), update, fields).map([](EncodedUpdate key) {
        return EncodedState{std::move(key.frames), key.state_sum};
    });
}

} // namespace wakesurf::protocol
