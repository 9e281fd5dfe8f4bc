#include "server/remote/web/answer_headers.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace wakesurf::server {

namespace {

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const auto begin = text.find_first_not_of(blank);
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

template <class Number = std::uint64_t>
std::optional<Number> number(std::string_view text) {
    Number value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || fault != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

// Parses "bytes 0-99/1000" and "bytes */1000".
std::optional<HttpAnswer::Range> content_range(std::string_view text) {
    constexpr std::string_view unit = "bytes ";
    const auto slash = text.find('/');
    if (!text.starts_with(unit) || slash == std::string_view::npos)
        return std::nullopt;
    const auto total = number(text.substr(slash + 1));
    if (!total)
        return std::nullopt;
    const auto part = text.substr(unit.size(), slash - unit.size());
    if (part == "*")
        return HttpAnswer::Range{std::nullopt, std::nullopt, *total};
    const auto dash = part.find('-');
    if (dash == std::string_view::npos)
        return std::nullopt;
    const auto first = number(part.substr(0, dash));
    const auto last = number(part.substr(dash + 1));
    if (!first || !last)
        return std::nullopt;
    return HttpAnswer::Range{first, last, *total};
}

} // namespace

void read_header(std::string_view line, HttpAnswer& answer) {
    if (line.starts_with("HTTP/")) {
        const auto space = line.find(' ');
        answer = {};
        if (space != std::string_view::npos)
            answer.status = number<int>(without_blanks(line.substr(space + 1, 3))).value_or(0);
        return;
    }
    const auto colon = line.find(':');
    if (colon == std::string_view::npos)
        return;
    const std::string_view name = line.substr(0, colon);
    const std::string_view value = without_blanks(line.substr(colon + 1));
    const auto is = [&](std::string_view known) {
        return std::equal(name.begin(), name.end(), known.begin(), known.end(), [](char a, char b) {
            return std::tolower(static_cast<unsigned char>(a)) == b;
        });
    };
    if (is("etag"))
        answer.etag = value;
    else if (is("last-modified"))
        answer.last_modified = value;
    else if (is("content-type"))
        answer.content_type = value;
    else if (is("location"))
        answer.location = value;
    else if (is("content-length"))
        answer.content_length = number(value);
    else if (is("content-range"))
        answer.range = content_range(value);
    else if (is("retry-after"))
        if (const auto seconds = number<std::uint32_t>(value))
            answer.retry_after = std::chrono::seconds(*seconds);
}

} // namespace wakesurf::server
