#include "server/net/proxy_protocol.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace wakesurf::server {

namespace {

using boost::asio::ip::address;
using Is = ProxyHeader::Is;

constexpr std::string_view text_begin = "PROXY ";
constexpr std::size_t longest_text = 107; ///< with its line's end
constexpr std::string_view binary_begin("\r\n\r\n\0\r\nQUIT\n", 12);
constexpr std::size_t fixed = 16; ///< bytes of version 2 before the addresses

bool may_become(std::string_view bytes, std::string_view begin) {
    const std::size_t both = std::min(bytes.size(), begin.size());
    return bytes.substr(0, both) == begin.substr(0, both);
}

/// Parses "PROXY TCP4 192.0.2.1 192.0.2.9 4711 443".
ProxyHeader parse_text(std::string_view bytes) {
    const auto end = bytes.substr(0, longest_text).find("\r\n");
    if (end == std::string_view::npos)
        return {bytes.size() < longest_text ? Is::Partial : Is::Malformed, 0, {}};
    ProxyHeader out{Is::Complete, end + 2, {}};
    const std::string_view rest = bytes.substr(text_begin.size(), end - text_begin.size());
    const auto space = rest.find(' ');
    const std::string_view family = rest.substr(0, space);
    if (family == "UNKNOWN")
        return out;
    if ((family != "TCP4" && family != "TCP6") || space == std::string_view::npos)
        return {Is::Malformed, 0, {}};
    const std::string_view addresses = rest.substr(space + 1);
    boost::system::error_code error;
    const address from =
        boost::asio::ip::make_address(std::string(addresses.substr(0, addresses.find(' '))), error);
    if (error || from.is_v4() != (family == "TCP4"))
        return {Is::Malformed, 0, {}};
    out.from = from;
    return out;
}

template <class Address>
address address_at(std::string_view bytes) {
    typename Address::bytes_type raw{};
    std::transform(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(raw.size()),
                   raw.begin(), [](char c) { return static_cast<unsigned char>(c); });
    return Address(raw);
}

ProxyHeader parse_binary(std::string_view bytes) {
    const auto byte = [&](std::size_t at) {
        return static_cast<unsigned>(static_cast<unsigned char>(bytes[at]));
    };
    if (bytes.size() < fixed)
        return {Is::Partial, 0, {}};
    const std::size_t length = fixed + (byte(14) << 8 | byte(15));
    const unsigned version = byte(12) >> 4;
    const unsigned command = byte(12) & 0xf;
    if (version != 2 || command > 1 || length > longest_proxy_header)
        return {Is::Malformed, 0, {}};
    if (bytes.size() < length)
        return {Is::Partial, 0, {}};
    ProxyHeader out{Is::Complete, length, {}};
    const unsigned family = byte(13) >> 4;
    constexpr std::size_t v4 = 12; // both addresses and ports
    constexpr std::size_t v6 = 36;
    if (command == 0) // the proxy's own health check
        return out;
    if (family == 1 && length >= fixed + v4)
        out.from = address_at<boost::asio::ip::address_v4>(bytes.substr(fixed));
    else if (family == 2 && length >= fixed + v6)
        out.from = address_at<boost::asio::ip::address_v6>(bytes.substr(fixed));
    else if (family == 1 || family == 2)
        return {Is::Malformed, 0, {}};
    return out;
}

} // namespace

ProxyHeader parse_proxy_header(std::string_view bytes) {
    for (const std::string_view begin : {text_begin, binary_begin}) {
        if (!may_become(bytes, begin))
            continue;
        if (bytes.size() < begin.size())
            return {Is::Partial, 0, {}};
        return begin == binary_begin ? parse_binary(bytes) : parse_text(bytes);
    }
    return {};
}

} // namespace wakesurf::server
