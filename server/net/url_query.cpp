#include "server/net/url_query.hpp"

#include <charconv>
#include <optional>

namespace wakesurf::server {

namespace {

std::optional<std::string> decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i] == '+' ? ' ' : text[i];
            continue;
        }
        unsigned char byte = 0;
        const std::string_view digits = text.substr(i + 1, 2);
        const char* const end = digits.data() + digits.size();
        const auto read = std::from_chars(digits.data(), end, byte, 16);
        if (digits.size() != 2 || read.ec != std::errc{} || read.ptr != end)
            return std::nullopt;
        out += static_cast<char>(byte);
        i += 2;
    }
    return out;
}

} // namespace

core::Result<std::map<std::string, std::string>> url_query(std::string_view text) {
    std::map<std::string, std::string> out;
    while (!text.empty()) {
        const auto end = std::min(text.find('&'), text.size());
        const std::string_view part = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto equals = part.find('=');
        const auto name = decoded(part.substr(0, equals));
        const auto value =
            equals == std::string_view::npos ? std::nullopt : decoded(part.substr(equals + 1));
        if (!name || !value || !out.emplace(*name, *value).second)
            return core::fail(core::Error::Code::InvalidArgument,
                              "the address has a query that cannot be read",
                              "write ?name=value&name=value, each name once");
    }
    return out;
}

} // namespace wakesurf::server
