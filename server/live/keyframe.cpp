#include "server/live/keyframe.hpp"

#include "core/base/work_memory.hpp"

#include <chrono>
#include <new>
#include <optional>
#include <stop_token>
#include <utility>

namespace wakesurf::server {

namespace {

/// The wait for others to release memory.
constexpr std::chrono::milliseconds patience_for_key{100};

} // namespace

SharedUpdate keyframe_of(const Update& update,
                         std::shared_ptr<const protocol::WireMesh> state,
                         std::uint32_t number,
                         const core::MemoryAccount* account) {
    std::optional<core::WorkMemory> memory;
    if (account != nullptr)
        memory.emplace(*account, std::stop_token(), patience_for_key);
    try {
        if (memory && !memory->grow(state->vertices() * protocol::encoding_bytes))
            return nullptr;
        protocol::EncodedUpdate from = update.wire;
        from.state = std::move(state);
        auto encoded = protocol::encode_key(number, from);
        if (!encoded)
            return nullptr;
        auto key = std::make_shared<Update>(update);
        key->wire = std::move(*encoded);
        key->wire.state.reset();
        key->memory = counted(account, key->wire.bytes);
        return key;
    } catch (const std::bad_alloc&) { // as without memory
        return nullptr;
    }
}

} // namespace wakesurf::server
