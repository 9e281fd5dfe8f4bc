// "Did you mean": the name that the caller most likely meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Returns the one of `names` that is spelt most alike, whatever the case and the underscores: `max_quads` is
/// maxQuads, `color` is colour. Empty where none is near: up to a third of the letters, at most three, may be
/// others. The first of several. Looks at 64 letters.
std::string nearest_name(std::string_view wanted, std::span<const std::string> names);

/// "there is `a`, `b`", or that there is nothing.
std::string there_is(std::span<const std::string> names);

} // namespace wakesurf::protocol
