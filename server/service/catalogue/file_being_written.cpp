#include "server/service/catalogue/file_being_written.hpp"

#include <cctype>
#include <string_view>

namespace wakesurf::server {

namespace fs = std::filesystem;

namespace {

constexpr int deepest = 3;
constexpr int most_files = 20'000;

bool within_a_name(std::string_view text, std::size_t at) {
    const auto alphanumeric = [&](std::size_t i) {
        return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
    };
    if (at >= text.size())
        return false;
    return alphanumeric(at) || text[at] == '_' || text[at] == '-' ||
           (text[at] == '.' && alphanumeric(at + 1));
}

bool speaks_of(std::string_view words, std::string_view name) {
    for (auto at = words.find(name); at != std::string_view::npos; at = words.find(name, at + 1))
        if ((at == 0 || !within_a_name(words, at - 1)) && !within_a_name(words, at + name.size()))
            return true;
    return false;
}

bool speaks_of_a_part(const std::string& words, const fs::path& file) {
    for (const auto& part : file)
        if (speaks_of(words, part.string()))
            return true;
    return false;
}

} // namespace

std::optional<std::string> file_being_written(const fs::path& source, const std::string& words) {
    std::error_code error;
    fs::path folder = fs::is_directory(source, error) ? source : source.parent_path();
    if (folder.empty())
        folder = ".";
    const auto since = fs::file_time_type::clock::now() - still_written;
    int seen = 0;
    for (fs::recursive_directory_iterator entry(folder, error), end;
         !error && entry != end && seen < most_files; entry.increment(error), ++seen) {
        if (entry.depth() >= deepest)
            entry.disable_recursion_pending();
        std::error_code unknown;
        const auto changed = fs::last_write_time(entry->path(), unknown);
        if (unknown || changed < since || !entry->is_regular_file(unknown))
            continue;
        const auto name = entry->path().lexically_relative(folder);
        if (speaks_of_a_part(words, name))
            return name.string();
    }
    return std::nullopt;
}

} // namespace wakesurf::server
