// A number as the shortest decimal text that reads back the same.
#pragma once

#include <charconv>
#include <string>

namespace wakesurf::protocol {

template <class T>
std::string number_text(T value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

} // namespace wakesurf::protocol
