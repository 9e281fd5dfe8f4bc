#include "importer/sources/series/numbered_files.hpp"

#include "importer/base/text.hpp"
#include "importer/sources/files/source_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

// Finds the number of a file in its name, and decides whether a dot in it is that of a decimal: `flow_0.25`
// is at a quarter, while `out2.10` is the tenth of a series called out2.

/// Splits a name into three parts.
struct NumberInName {
    std::string prefix;
    std::string number; ///< digits, perhaps with a sign, a dot or an exponent
    std::string suffix; ///< with the extension
};

bool digit_at(std::string_view text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

bool letter_at(std::string_view text, std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

std::size_t first_digit(std::string_view text, std::size_t end) {
    while (end > 0 && digit_at(text, end - 1))
        --end;
    return end;
}

// Returns the beginning of digits, a dot and digits; of 1.2.3 that of the last ones alone.
std::size_t with_decimals(std::string_view text, std::size_t begin) {
    if (begin < 2 || text[begin - 1] != '.' || !digit_at(text, begin - 2))
        return begin;
    const auto whole = first_digit(text, begin - 1);
    const bool version = whole > 1 && text[whole - 1] == '.' && digit_at(text, whole - 2);
    return version ? begin : whole;
}

std::size_t with_mantissa(std::string_view text, std::size_t begin) {
    if (begin < 3 || (text[begin - 1] != '-' && text[begin - 1] != '+') ||
        (text[begin - 2] != 'e' && text[begin - 2] != 'E') || !digit_at(text, begin - 3))
        return begin;
    return with_decimals(text, first_digit(text, begin - 2));
}

bool is_sign(std::string_view text, std::size_t at) {
    return text[at] == '-' && (at == 0 || (!digit_at(text, at - 1) && !letter_at(text, at - 1)));
}

// Allows differences that are whole multiples of the smallest: files may be missing.
bool are_regular(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    std::vector<double> gaps;
    for (std::size_t i = 1; i < values.size(); ++i)
        gaps.push_back(values[i] - values[i - 1]);
    const auto least = std::min_element(gaps.begin(), gaps.end());
    return least == gaps.end() || std::all_of(gaps.begin(), gaps.end(), [&](double gap) {
               return std::abs(gap / *least - std::round(gap / *least)) < 1e-6;
           });
}

bool are_even(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    double least = HUGE_VAL;
    double most = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        least = std::min(least, values[i] - values[i - 1]);
        most = std::max(most, values[i] - values[i - 1]);
    }
    return most <= 1.5 * least;
}

// Says whether a number behind `prefix` is a time: t0.5, time0.5 and flow_0.5 are, out2.1 is not.
bool speaks_of_time(const std::string& prefix) {
    if (prefix.empty() || !letter_at(prefix, prefix.size() - 1))
        return true;
    auto begin = prefix.size();
    while (begin > 0 && letter_at(prefix, begin - 1))
        --begin;
    const std::string word = lower_case(prefix.substr(begin));
    return word == "t" || word == "time";
}

// Finds the last number of a name without its extension: digits that no letter follows, with a sign if a
// separator is before it, with the digits before a dot, and with an exponent that has a sign: a_10_b.vtk,
// t_-3.vtk, t_0.25.vtk, t_1e-05.vtk.
std::optional<NumberInName> number_in_name(const std::string& name) {
    const auto dot = name.rfind('.');
    std::string_view stem(name);
    stem = stem.substr(0, dot == std::string::npos || dot == 0 ? name.size() : dot);
    auto end = stem.size();
    while (end > 0 && (!digit_at(stem, end - 1) || letter_at(stem, end)))
        --end;
    if (end == 0)
        return std::nullopt;
    const auto last = first_digit(stem, end);
    auto begin = with_mantissa(stem, last);
    if (begin == last)
        begin = with_decimals(stem, last);
    if (begin > 0 && is_sign(stem, begin - 1))
        --begin;
    return NumberInName{name.substr(0, begin), name.substr(begin, end - begin), name.substr(end)};
}

// Splits at the dot instead: the digits before it go to the prefix.
NumberInName behind_the_dot(const NumberInName& whole) {
    const auto dot = whole.number.rfind('.');
    if (dot == std::string::npos)
        return whole;
    return {whole.prefix + whole.number.substr(0, dot + 1), whole.number.substr(dot + 1),
            whole.suffix};
}

// Returns the value of a name's middle between `prefix` and what follows it; empty if it is no number.
// @param decimals  dots and exponents are allowed
std::optional<double>
number_after(const std::string& prefix, const std::string& text, bool decimals) {
    const bool negative = text.size() > 1 && text.front() == '-';
    if (negative && !is_sign(prefix + '-', prefix.size()))
        return std::nullopt;
    const std::string_view digits = std::string_view(text).substr(negative ? 1 : 0);
    if (!digit_at(digits, 0) || !digit_at(digits, digits.size() - 1) ||
        digits.find_first_not_of(decimals ? "0123456789.eE+-" : "0123456789") !=
            std::string_view::npos)
        return std::nullopt;
    return finite_number(text);
}

// Says whether the dots in the numbers of a series are those of decimals. If both readings fit, the prefix
// decides: out2.1, but t0.5.
// @param numbers  of all files with one prefix and suffix
bool are_decimals(const std::string& prefix, std::span<const std::string> numbers) {
    std::map<std::string, std::vector<double>> behind; // of the digits before the dot
    std::vector<double> values;
    std::set<std::size_t> widths;
    bool zero_first = false;
    for (const auto& number : numbers) {
        const auto dot = number.find('.');
        const auto value = finite_number(number);
        if (dot == std::string::npos || !value)
            continue;
        const std::string before = number.substr(0, dot);
        const std::string after = number.substr(dot + 1);
        if (before.size() > 1 && before.front() == '0')
            return false; // out_01.0007
        zero_first = zero_first || (after.size() > 1 && after.front() == '0');
        widths.insert(after.size());
        behind[before].push_back(finite_number(after).value_or(0.0));
        values.push_back(*value);
    }
    if (std::set(values.begin(), values.end()).size() != values.size())
        return false; // out2.1 and out2.10
    if (widths.size() > 1 && zero_first)
        return true; // 0.05 and 0.2
    if (behind.size() == values.size())
        return speaks_of_time(prefix);
    const bool even = are_even(values);
    const bool counted = std::all_of(behind.begin(), behind.end(), [](const auto& series) {
        return series.second.size() > 1 && are_regular(series.second);
    });
    return even == counted ? speaks_of_time(prefix) : even;
}

bool digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Returns start and length of `*`, %d, %4d or %04d.
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

// Returns the text between a prefix and a suffix; empty for names without both.
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

// Tells flow_1, flow_2 from flow_01, flow_02: they are two series.
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

// Returns the files that differ from the given one by its last number alone.
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
