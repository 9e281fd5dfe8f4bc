// Text of any kind as a field of RFC 4180.
#pragma once

#include <string>

namespace wakesurf::protocol {

inline std::string csv_name(const std::string& name) {
    std::string out = "\"";
    for (const char c : name)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

} // namespace wakesurf::protocol
