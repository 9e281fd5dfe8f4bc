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

void append_with_lengths(std::string& out, const SharedFrames& frames) {
    for (const auto& frame : frames) {
        const auto size = static_cast<std::uint32_t>(frame->size());
        for (int shift = 0; shift < 32; shift += 8)
            out += static_cast<char>(size >> shift & 0xffU);
        out.append(reinterpret_cast<const char*>(frame->data()), frame->size());
    }
}

} // namespace wakesurf::protocol
