#include "protocol/files/mesh_names.hpp"

#include <cctype>

namespace wakesurf::protocol {

namespace {

std::string word(const std::string& name) {
    std::string out;
    for (const char c : name)
        out += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return out.empty() ? "_" : out;
}

std::string capitals(const std::string& name) {
    std::string out = "_";
    for (const char c : word(name))
        out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return out;
}

template <class Spelling>
std::vector<std::string>
spelt(const MeshScalars& scalars, std::set<std::string> taken, Spelling spelling) {
    std::vector<std::string> out;
    for (const auto& [name, values] : scalars) {
        const std::string first = spelling(name);
        std::string free = first;
        for (int number = 2; !taken.insert(free).second; ++number)
            free = first + "_" + std::to_string(number);
        out.push_back(free);
    }
    return out;
}

} // namespace

std::vector<std::string> words_of(const MeshScalars& scalars, std::set<std::string> taken) {
    return spelt(scalars, std::move(taken), word);
}

std::vector<std::string> gltf_names(const MeshScalars& scalars, std::set<std::string> taken) {
    return spelt(scalars, std::move(taken), capitals);
}

} // namespace wakesurf::protocol
