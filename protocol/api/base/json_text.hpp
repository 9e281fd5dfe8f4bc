// JSON text from outside -> value, within limits. The parser itself copes with deep nesting; copying and
// dumping what it made does not (stack), so depth is limited before anything is built.
#pragma once

#include "core/base/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Why a text is not taken for JSON, in words that name the place: most often a script has sent NaN.
struct JsonFault {
    std::string message;
    std::string hint;
};

/// REQUIRES: nlohmann::json::parse refuses the text. Cost: as parsing it.
JsonFault json_fault(std::string_view text);

/// REQUIRES: JSON of which an object has a member twice.
JsonFault member_twice(std::string_view text);

struct JsonLimits {
    std::size_t bytes = std::size_t{64} << 10;
    std::size_t depth = 32;
    std::size_t values = std::size_t{1} << 22; ///< each takes some 40 bytes of memory
};

/// Error: OverLimit (too long, too deep, too many values), Corrupt (not JSON, not UTF-8, a number beyond
/// double), InvalidArgument (an object has a member twice: readers would take different ones for it).
core::Result<nlohmann::json> parse_json(std::string_view text, JsonLimits limits);

/// Compact, or indented where `indent` >= 0. Never throws: what is not UTF-8 is replaced by U+FFFD.
std::string json_text(const nlohmann::json& value, int indent = -1);

} // namespace wakesurf::protocol
