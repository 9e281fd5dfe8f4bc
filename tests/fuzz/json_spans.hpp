// The positions of the values in a JSON text, without building them: enough for a mutation, in a hundredth of
// a parser's time.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace wakesurf::fuzz {

struct JsonSpan {
    enum class Kind { Object, Array, Text, Number, Word };

    Kind kind = Kind::Word;
    std::size_t begin = 0, end = 0; ///< in the text
    std::size_t parent = 0;         ///< index of the span around it; of the first its own
    std::size_t key = 0;   ///< where its member begins; its own begin where it is in no object
    std::size_t inner = 0; ///< how many values or members it has

    bool structured() const { return kind == Kind::Object || kind == Kind::Array; }
};

/// Returns the value that begins at `from` and all values within, each before those within it; empty if there
/// is none. Looser than a parser: strings and numbers are not checked.
std::optional<std::vector<JsonSpan>> json_spans(std::string_view text, std::size_t from = 0);

} // namespace wakesurf::fuzz
