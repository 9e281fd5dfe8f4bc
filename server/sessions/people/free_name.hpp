// A name that no other participant has.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace wakesurf::server {

/// Returns `name`, or `name 2`, `name 3`, ...: the first that is not `taken`; at most `longest` bytes.
std::string free_name(const std::string& name,
                      std::size_t longest,
                      const std::function<bool(const std::string&)>& taken);

} // namespace wakesurf::server
