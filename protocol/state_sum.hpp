// A checksum of 32 bit words that scripts compute fast: four lanes of xor, rotate, multiply. protocol/README.md, State
// checksum. Twin: web-client/src/protocol/stateSum.ts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::protocol {

/// Of 32 bit words as they lie in memory; the last one padded with zeros. Any change of one word changes it.
std::uint32_t word_sum(std::span<const std::byte> bytes);

} // namespace wakesurf::protocol
