// Names people give themselves and their sessions, as others get to see them. They come from anywhere, so nothing in them may act:
// no control characters, nothing that turns the writing direction or cannot be seen.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Without such characters, blanks in a row as one, none at the ends; at most `longest` bytes, cut between characters. `name` is
/// UTF-8, as all JSON is; what is not is left out.
std::string display_name(std::string_view name, std::size_t longest);

/// `name`, or `name 2`, `name 3`, ...: the first that is not `taken`; at most `longest` bytes.
std::string free_name(const std::string& name,
                      std::size_t longest,
                      const std::function<bool(const std::string&)>& taken);

} // namespace wakesurf::server
