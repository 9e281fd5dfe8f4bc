#include "server/remote/zarr/zarr_array.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

std::uint64_t ZarrArray::chunk_numbers() const {
    std::uint64_t out = 1;
    for (const std::uint64_t along : chunks)
        out *= along;
    return out;
}

std::string ZarrArray::key(const std::vector<std::uint64_t>& at) const {
    std::string out = key_prefix;
    for (const std::uint64_t each : at) {
        if (!out.empty())
            out += separator;
        out += std::to_string(each);
    }
    return out;
}

bool ZarrArray::may_miss_values() const {
    return missing_is_nan || !missing.empty() || (fill && !std::isfinite(*fill));
}

bool is_plain_name(std::string_view name) {
    const auto plain = [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-' || c == '.' || c == '+';
    };
    return !name.empty() && name.size() <= 255 && name != "." && name != ".." &&
           std::all_of(name.begin(), name.end(), plain);
}

} // namespace wakesurf::server
