#include "protocol/api/base/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>
#include <vector>

namespace wakesurf::protocol {

namespace {

std::string folded(std::string_view name) {
    std::string out;
    for (const char c : name.substr(0, 64))
        if (c != '_' && c != '-')
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

/// Returns how many letters must be changed, put in or left out (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string nearest_name(std::string_view wanted, std::span<const std::string> names) {
    const std::string asked = folded(wanted);
    std::size_t least = std::min<std::size_t>(3, asked.size() / 3) + 1;
    std::string found;
    for (const std::string& each : names)
        if (const auto away = distance(asked, folded(each)); away < least) {
            least = away;
            found = each;
        }
    return found;
}

std::string there_is(std::span<const std::string> names) {
    std::string out;
    for (const std::string& each : names)
        out += (out.empty() ? "there is `" : ", `") + each + '`';
    return out.empty() ? "it takes none" : out;
}

} // namespace wakesurf::protocol
