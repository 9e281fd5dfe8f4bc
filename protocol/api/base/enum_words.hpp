// The words for the values of an enumeration, as messages and files have them.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace wakesurf::protocol {

template <class Enum>
using Word = std::pair<Enum, std::string_view>;

/// Is specialised for each enumeration that is a member.
template <class Enum>
inline constexpr std::array<Word<Enum>, 0> words_of{};

/// Returns the word for it.
template <class Enum>

requires(!words_of<Enum>.empty()) constexpr std::string_view name(Enum value) {
    for (const auto& [each, word] : words_of<Enum>)
        if (each == value)
            return word;
    return {};
}

/// Returns nothing for any other word.
template <class Enum>
constexpr std::optional<Enum> value_of(std::string_view text) {
    for (const auto& [each, word] : words_of<Enum>)
        if (word == text)
            return each;
    return std::nullopt;
}

} // namespace wakesurf::protocol
