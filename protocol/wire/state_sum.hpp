// A checksum of 32 bit words that scripts and vector units compute fast: sums, and sums of sums, in four
// lanes. protocol/wire/FORMAT.md, State sum. Twin: web-client/src/protocol/wireMesh.ts.
#pragma once

#include <cstdint>
#include <span>

namespace wakesurf::protocol {

/// Returns the checksum, which finds accidents, not intent: any change of one word, and nearly all others.
std::uint32_t word_sum(std::span<const std::uint32_t> words);

/// Returns the checksum of codes, each one word.
std::uint32_t word_sum(std::span<const std::uint16_t> codes);

} // namespace wakesurf::protocol
