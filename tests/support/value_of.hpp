// Says of results and texts what tests of all rooms ask, so that a failure shows the reason. It is in the
// namespace above all rooms.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string_view>
#include <utility>

namespace wakesurf {

/// Returns the value of a result or an optional. Where there is none it throws, which ends the test with the
/// error's message.
template <class Holder>
typename Holder::value_type value_of(Holder holder) {
    if constexpr (requires { holder.error().message; }) {
        if (!holder)
            throw std::runtime_error(holder.error().message);
    }
    return std::move(holder).value();
}

/// Says whether `words` stand in `text`, and shows the text where a test expects otherwise.
inline testing::AssertionResult holds(std::string_view text, std::string_view words) {
    const bool found = text.find(words) != std::string_view::npos;
    return (found ? testing::AssertionSuccess() : testing::AssertionFailure())
           << "'" << words << "' is " << (found ? "" : "not ") << "in: " << text;
}

} // namespace wakesurf
