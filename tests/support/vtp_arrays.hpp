// The arrays of a .vtp file with inline compressed data, read back from VTK's description of the format.
#pragma once

#include <cstring>
#include <string>
#include <vector>

namespace wakesurf::tests {

/// Returns the bytes of the array `name` of VTK type `type`; empty if there is none. Throws
/// std::runtime_error for a malformed file.
std::string vtp_bytes(const std::string& file, const std::string& type, const std::string& name);

/// Returns them as values.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& type, const std::string& name) {
    const std::string bytes = vtp_bytes(file, type, name);
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

} // namespace wakesurf::tests
