// The arrays of a .vtp file with appended raw data, read back as VTK would.
#pragma once

#include <cstdint>
#include <cstring>
#include <regex>
#include <string>
#include <vector>

namespace wakesurf::tests {

/// The array `name` of VTK type `type`, by its offset into the appended data; empty if there is none.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& type, const std::string& name) {
    const std::regex entry("<DataArray type=\"" + type + "\" Name=\"" + name +
                           "\"[^>]*offset=\"([0-9]+)\"");
    const auto xml = file.substr(0, file.find("<AppendedData"));
    std::smatch match;
    if (!std::regex_search(xml, match, entry))
        return {};
    const auto start = file.find("\n_") + 2 + std::stoull(match[1]);
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, file.data() + start, sizeof(bytes));
    std::vector<T> values(bytes / sizeof(T));
    std::memcpy(values.data(), file.data() + start + sizeof(bytes), bytes);
    return values;
}

} // namespace wakesurf::tests
