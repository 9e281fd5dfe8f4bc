#include "server/import/sources/series/numbered_files.hpp"

#include "server/import/sources/files/file_names.hpp"
#include "server/import/sources/files/named_path.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

namespace wakesurf::server {

using core::Error;
namespace fs = std::filesystem;

namespace {

// What stands before and after the number.
struct Shape {
    std::string prefix;
    std::string suffix;
};

bool digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// The number at the end of the stem; with decimals where digits, a dot and digits end it.
std::optional<Shape> shape_of(const std::string& name) {
    const auto dot = name.rfind('.');
    const auto end = dot == std::string::npos ? name.size() : dot;
    auto begin = end;
    while (begin > 0 && digit(name[begin - 1]))
        --begin;
    if (begin == end)
        return std::nullopt;
    if (begin > 1 && name[begin - 1] == '.' && digit(name[begin - 2]))
        for (--begin; begin > 0 && digit(name[begin - 1]);)
            --begin;
    return Shape{name.substr(0, begin), name.substr(end)};
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

std::optional<double> number_in(const std::string& name, const Shape& shape) {
    if (name.size() <= shape.prefix.size() + shape.suffix.size() ||
        !name.starts_with(shape.prefix) || !name.ends_with(shape.suffix))
        return std::nullopt;
    const auto middle =
        name.substr(shape.prefix.size(), name.size() - shape.prefix.size() - shape.suffix.size());
    if (!digit(middle.front()) || !digit(middle.back()) ||
        middle.find_first_not_of("0123456789.") != std::string::npos)
        return std::nullopt;
    return finite_number(middle);
}

core::Result<NumberedFiles> find(const fs::path& given, const Shape& shape) {
    const fs::path folder = given.parent_path().empty() ? fs::path(".") : given.parent_path();
    std::vector<std::pair<double, fs::path>> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unknown;
        if (const auto number = number_in(entry->path().filename().string(), shape);
            number && !entry->is_directory(unknown))
            found.emplace_back(*number, given.parent_path() / entry->path().filename());
    }
    if (error)
        return core::fail(Error::Code::Io, "the folder of " + given.filename().string() +
                                               " cannot be listed: " + error.message());
    std::sort(found.begin(), found.end());
    const auto twice =
        std::adjacent_find(found.begin(), found.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != found.end())
        return core::fail(Error::Code::Corrupt,
                          twice->second.filename().string() + " and " +
                              std::next(twice)->second.filename().string() +
                              " have the same number",
                          "remove one of them, or name the series by a pattern");
    NumberedFiles out{tidy_name(shape.prefix), {}};
    for (auto& [number, path] : found) {
        // The file that was asked for may be a link to anywhere; those found beside it may not.
        if (path != given)
            if (const auto inside = named_path(folder, path.filename().string(),
                                               "the series of " + given.filename().string());
                !inside)
                return tl::unexpected(inside.error());
        out.files.push_back(std::move(path));
        out.numbers.push_back(number);
    }
    return out;
}

} // namespace

bool is_pattern(const fs::path& path) {
    return wildcard(path.filename().string()).has_value();
}

core::Result<NumberedFiles> numbered_files(const fs::path& path) {
    const std::string name = path.filename().string();
    std::error_code unknown;
    if (const auto place = wildcard(name); place && !fs::exists(path, unknown)) {
        const auto [at, length] = *place;
        if (wildcard(name, at + length))
            return core::fail(Error::Code::InvalidArgument, name + " holds more than one pattern",
                              "use one * or %d in place of the file's number");
        auto series = find(path, {name.substr(0, at), name.substr(at + length)});
        if (series && series->files.empty())
            return core::fail(Error::Code::NotFound, "no file matches " + name,
                              "the * stands for the number of the file");
        return series;
    }
    NumberedFiles alone{tidy_name(path.stem().string()), {path}};
    const auto shape = shape_of(name);
    if (!shape)
        return alone;
    auto series = find(path, *shape);
    if (series && series->files.size() < 2)
        return alone;
    return series;
}

} // namespace wakesurf::server
