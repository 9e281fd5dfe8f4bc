// The one way in which a command prints text: names of files, fields or users in it have no effect on a
// terminal.
#pragma once

#include "core/base/plain_text.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace wakesurf::server {

template <class... Arguments>
void tell(std::FILE* stream, fmt::format_string<Arguments...> words, Arguments&&... arguments) {
    const std::string text = fmt::format(words, std::forward<Arguments>(arguments)...);
    std::fputs(core::printable(text).c_str(), stream);
}

template <class... Arguments>
void tell(fmt::format_string<Arguments...> words, Arguments&&... arguments) {
    tell(stdout, words, std::forward<Arguments>(arguments)...);
}

} // namespace wakesurf::server
