#include "importer/sources/series/number_in_name.hpp"

#include "importer/sources/files/file_names.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

namespace {

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

// Where digits, a dot and digits begin; of 1.2.3 the last ones alone.
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

// In whole multiples of the smallest: files may be missing.
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

// t0.5, time0.5 and flow_0.5 are times; out2.1 is no time.
bool speaks_of_time(const std::string& prefix) {
    if (prefix.empty() || !letter_at(prefix, prefix.size() - 1))
        return true;
    auto begin = prefix.size();
    while (begin > 0 && letter_at(prefix, begin - 1))
        --begin;
    std::string word = prefix.substr(begin);
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word == "t" || word == "time";
}

} // namespace

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

NumberInName behind_the_dot(const NumberInName& whole) {
    const auto dot = whole.number.rfind('.');
    if (dot == std::string::npos)
        return whole;
    return {whole.prefix + whole.number.substr(0, dot + 1), whole.number.substr(dot + 1),
            whole.suffix};
}

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

} // namespace wakesurf::importer
