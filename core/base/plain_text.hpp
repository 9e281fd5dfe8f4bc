// Text that others have written, made so that nothing in it acts: no control characters, nothing that turns
// the writing direction or cannot be seen.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace wakesurf::core {

/// Returns a name as people see it: without such characters, runs of blanks as one, none at the ends; at most
/// `longest` bytes, cut between characters. What is not UTF-8 is left out.
std::string display_name(std::string_view name, std::size_t longest);

/// Makes a text of several lines displayable in this way; blanks and line ends stay.
std::string display_lines(std::string_view text, std::size_t longest);

/// Returns text that is safe on a terminal or in a log: such characters as \u001b, bytes that are not UTF-8
/// as \xff. Line ends and tabs stay.
std::string printable(std::string_view text);

/// Makes a text printable in this way, on one line.
std::string printable_line(std::string_view text);

} // namespace wakesurf::core
