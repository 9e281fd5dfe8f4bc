// libwakesurf_frames.so: the decoder of mesh frames (protocol/wire/mesh_decoder.hpp) behind functions of C, which the client for Python
// calls by ctypes: wakesurf/frames.py. No exception leaves them. A decoder is for one thread at a time.
#include "protocol/wire/mesh_decoder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>

namespace {

using wakesurf::protocol::AttributeRange;
using wakesurf::protocol::MeshDecoder;
using wakesurf::protocol::WireMesh;

/// A decoder, and the text of its last error.
struct Decoder {
    MeshDecoder decoder;
    std::string error;
};

/// The newest state in numbers; frames.py has the same struct.
struct StateInfo {
    std::uint32_t epoch, seq, vertices, cells, attributes, lossless, state_sum;
};

/// Returns the newest mesh; null before the first.
const WireMesh* mesh_of(const Decoder& decoder) {
    return decoder.decoder.newest() ? decoder.decoder.newest()->mesh.get() : nullptr;
}

/// Copies rows of equally many numbers, if `into` has room for just those.
template <class Rows, class Number, class Write>
bool copied(const Rows& rows, std::size_t width, std::span<Number> into, Write write) {
    if (into.size() != rows.size() * width)
        return false;
    auto at = into.begin();
    for (const auto& row : rows)
        at = write(row, at);
    return true;
}

} // namespace

#define WAKESURF_EXPORT extern "C" [[gnu::visibility("default")]]

/// Returns a decoder for the frames of one surface; null if there is no memory.
WAKESURF_EXPORT Decoder* wakesurf_frames_new() noexcept {
    return new (std::nothrow) Decoder;
}

WAKESURF_EXPORT void wakesurf_frames_free(Decoder* decoder) noexcept {
    delete decoder;
}

/// Folds one frame. Returns 1 if it completed a state, 0 if more frames have to follow, -1 after an error.
WAKESURF_EXPORT int
wakesurf_frames_fold(Decoder* decoder, const std::byte* frame, std::size_t size) noexcept {
    try {
        const auto whole = decoder->decoder.fold({frame, size});
        if (whole)
            return *whole ? 1 : 0;
        decoder->error = whole.error().message;
        if (!whole.error().hint.empty())
            decoder->error += ": " + whole.error().hint;
    } catch (...) {
        decoder->decoder = MeshDecoder(); // half an update may be in it
        decoder->error = "no memory";     // short enough to need none
    }
    return -1;
}

/// Returns what the last error was, until the next call of fold.
WAKESURF_EXPORT const char* wakesurf_frames_error(const Decoder* decoder) noexcept {
    return decoder->error.c_str();
}

/// Describes the newest state. Returns whether there is one; so do all that follow, which want room for just what they write.
WAKESURF_EXPORT bool wakesurf_frames_info(const Decoder* decoder, StateInfo* into) noexcept {
    const WireMesh* mesh = mesh_of(*decoder);
    if (mesh == nullptr)
        return false;
    const auto& header = decoder->decoder.newest()->header;
    *into = {header.epoch,
             header.seq,
             static_cast<std::uint32_t>(mesh->vertices()),
             static_cast<std::uint32_t>(mesh->cells().size()),
             static_cast<std::uint32_t>(mesh->codes.size()),
             (header.flags & header.lossless) != 0 ? 1U : 0U,
             header.state_sum};
    return true;
}

/// Copies the places of the vertices on the lattice: 3 numbers each.
WAKESURF_EXPORT bool
wakesurf_frames_nodes(const Decoder* decoder, std::int32_t* into, std::size_t numbers) noexcept {
    const WireMesh* mesh = mesh_of(*decoder);
    return mesh != nullptr &&
           copied(mesh->position, 3, std::span(into, numbers),
                  [](const auto& node, auto at) { return std::ranges::copy(node, at).out; });
}

/// Copies the cells: 4 corners and 4 mids each, 0xffffffff for none.
WAKESURF_EXPORT bool
wakesurf_frames_cells(const Decoder* decoder, std::uint32_t* into, std::size_t numbers) noexcept {
    const WireMesh* mesh = mesh_of(*decoder);
    return mesh != nullptr &&
           copied(mesh->cells(), 8, std::span(into, numbers), [](const auto& cell, auto at) {
               return std::ranges::copy(cell.mid, std::ranges::copy(cell.corner, at).out).out;
           });
}

/// Copies the values of an attribute, one a vertex, NaN for a missing one.
WAKESURF_EXPORT bool wakesurf_frames_attribute(const Decoder* decoder,
                                               std::uint32_t attribute,
                                               double* into,
                                               std::size_t numbers) noexcept {
    const WireMesh* mesh = mesh_of(*decoder);
    if (mesh == nullptr || attribute >= mesh->codes.size())
        return false;
    const AttributeRange& range = mesh->ranges[attribute];
    return copied(mesh->codes[attribute], 1, std::span(into, numbers),
                  [&](std::uint16_t code, auto at) {
                      *at = range.value(code);
                      return ++at;
                  });
}
