#include "importer/sources/series/numbered_files.hpp"

#include "importer/sources/files/file_names.hpp"
#include "importer/sources/files/named_path.hpp"
#include "importer/sources/series/number_in_name.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <tuple>
#include <utility>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

bool digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Start and length of `*`, %d, %4d or %04d.
std::optional<std::pair<std::size_t, std::size_t>> wildcard(const std::string& name,
                                                            std::size_t from = 0) {
    for (std::size_t i = from; i < name.size(); ++i) {
        if (name[i] == '*')
            return std::pair{i, std::size_t{1}};
        if (name[i] != '%')
            continue;
        std::size_t end = i + 1;
        while (end < name.size() && digit(name[end]))
            ++end;
        if (end < name.size() && (name[end] == 'd' || name[end] == 'i' || name[end] == 'u'))
            return std::pair{i, end + 1 - i};
    }
    return std::nullopt;
}

// What is between a prefix and a suffix; nothing of names that have not both.
std::optional<std::string>
between(const std::string& name, const std::string& prefix, const std::string& suffix) {
    if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) ||
        !name.ends_with(suffix))
        return std::nullopt;
    return name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
}

core::Result<std::vector<std::string>> names_beside(const fs::path& given) {
    const fs::path folder = given.parent_path().empty() ? fs::path(".") : given.parent_path();
    std::vector<std::string> out;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unknown;
        if (!entry->is_directory(unknown))
            out.push_back(entry->path().filename().string());
    }
    if (error)
        return core::fail(Error::Code::Io, "the folder of " + given.filename().string() +
                                               " cannot be listed: " + error.message());
    return out;
}

struct Member {
    double value = 0.0;
    std::string number; ///< as the name has it
    std::string name;

    bool operator<(const Member& other) const {
        return std::tie(value, name) < std::tie(other.value, other.name);
    }
};

std::vector<Member>
members_of(const std::vector<std::string>& names, const NumberInName& shape, bool decimals) {
    std::vector<Member> out;
    for (const auto& name : names)
        if (const auto middle = between(name, shape.prefix, shape.suffix))
            if (const auto value = number_after(shape.prefix, *middle, decimals))
                out.push_back({*value, *middle, name});
    std::sort(out.begin(), out.end());
    return out;
}

bool same_number_twice(const std::vector<Member>& members) {
    return std::adjacent_find(members.begin(), members.end(), [](const auto& a, const auto& b) {
               return a.value == b.value;
           }) != members.end();
}

// flow_1, flow_2 and flow_01, flow_02 are two series.
bool is_padded_as(const std::string& number, const std::string& given) {
    const bool filled = number.size() > 1 && number.front() == '0';
    if (given.size() > 1 && given.front() == '0')
        return number.size() == given.size() || (number.size() > given.size() && !filled);
    return !filled;
}

core::Result<NumberedFiles>
series_of(const fs::path& given, const std::string& prefix, const std::vector<Member>& members) {
    const auto twice =
        std::adjacent_find(members.begin(), members.end(),
                           [](const auto& a, const auto& b) { return a.value == b.value; });
    if (twice != members.end())
        return core::fail(Error::Code::Corrupt,
                          twice->name + " and " + std::next(twice)->name + " have the same number",
                          "remove one of them, or name the series by a pattern");
    const fs::path folder = given.parent_path().empty() ? fs::path(".") : given.parent_path();
    NumberedFiles out{tidy_name(prefix), {}};
    for (const Member& member : members) {
        // The file that was asked for may be a link to anywhere; those found beside it may not.
        const fs::path path = given.parent_path() / member.name;
        if (path != given)
            if (const auto inside =
                    named_path(folder, member.name, "the series of " + given.filename().string());
                !inside)
                return tl::unexpected(inside.error());
        out.files.push_back(path);
        out.numbers.push_back(member.value);
    }
    if (out.name.empty() && !out.files.empty())
        out.name = out.files.front().stem().string();
    return out;
}

core::Result<NumberedFiles> of_pattern(const fs::path& path, std::size_t at, std::size_t length) {
    const std::string name = path.filename().string();
    if (wildcard(name, at + length))
        return core::fail(Error::Code::InvalidArgument, name + " holds more than one pattern",
                          "use one * or %d in place of the file's number");
    const auto names = names_beside(path);
    if (!names)
        return tl::unexpected(names.error());
    const NumberInName shape{name.substr(0, at), {}, name.substr(at + length)};
    auto members = members_of(*names, shape, true);
    if (same_number_twice(members)) // as 2.1 and 2.10 are for decimals
        members = members_of(*names, shape, false);
    if (members.empty())
        return core::fail(Error::Code::NotFound, "no file matches " + name,
                          "the * stands for the number of the file");
    return series_of(path, shape.prefix, members);
}

// The files that differ from the given one by its last number alone.
core::Result<NumberedFiles> of_number(const fs::path& path, const NumberInName& whole) {
    const auto names = names_beside(path);
    if (!names)
        return tl::unexpected(names.error());
    auto members = members_of(*names, whole, true);
    std::vector<std::string> dotted;
    for (const Member& member : members)
        if (member.number.find('.') != std::string::npos)
            dotted.push_back(member.number);
    NumberInName shape = whole;
    if (!dotted.empty() && !are_decimals(whole.prefix, dotted)) {
        shape = behind_the_dot(whole);
        members = members_of(*names, shape, false);
    }
    if (same_number_twice(members))
        std::erase_if(members, [&](const Member& member) {
            return !is_padded_as(member.number, shape.number);
        });
    return series_of(path, shape.prefix, members);
}

} // namespace

bool is_pattern(const fs::path& path) {
    return wildcard(path.filename().string()).has_value();
}

core::Result<NumberedFiles> numbered_files(const fs::path& path, bool alone) {
    const std::string name = path.filename().string();
    std::error_code unknown;
    if (const auto place = wildcard(name); place && !fs::exists(path, unknown))
        return of_pattern(path, place->first, place->second);
    NumberedFiles one{tidy_name(path.stem().string()), {path}};
    const auto number = number_in_name(name);
    if (alone || !number)
        return one;
    auto series = of_number(path, *number);
    if (series && series->files.size() < 2)
        return one;
    return series;
}

} // namespace wakesurf::importer
