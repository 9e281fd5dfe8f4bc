#include "server/net/trusted_proxies.hpp"

#include "server/net/admission.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
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

namespace {

using boost::asio::ip::address;
using boost::asio::ip::address_v6;
using boost::asio::ip::network_v6;

constexpr unsigned mapped_bits = 96;

address_v6 as_v6(const address& given) {
    return given.is_v4()
               ? boost::asio::ip::make_address_v6(boost::asio::ip::v4_mapped, given.to_v4())
               : given.to_v6();
}

std::optional<address> read_address(std::string_view text) {
    boost::system::error_code error;
    const address out = boost::asio::ip::make_address(std::string(text), error);
    return error ? std::nullopt : std::optional(plain_address(out));
}

/// Parses an address as proxies write it: also in brackets or quotes, also with a port.
std::optional<address> read_hop(std::string_view text) {
    if (text.size() > 1 && text.front() == '"' && text.back() == '"')
        text = text.substr(1, text.size() - 2);
    if (text.starts_with('['))
        return read_address(text.substr(1, text.find(']') - 1));
    if (std::count(text.begin(), text.end(), ':') == 1)
        text = text.substr(0, text.find(':'));
    return read_address(text);
}

} // namespace

core::Result<TrustedProxies> TrustedProxies::parse(const std::vector<std::string>& texts) {
    TrustedProxies out;
    for (const std::string& text : texts) {
        const auto slash = text.find('/');
        const auto found = read_address(std::string_view(text).substr(0, slash));
        const unsigned most = found && found->is_v4() ? 32 : 128;
        unsigned bits = most;
        bool good = found.has_value();
        if (good && slash != std::string::npos) {
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data() + slash + 1, end, bits);
            good = error == std::errc{} && stop == end && bits <= most;
        }
        if (!good)
            return core::fail(
                core::Error::Code::InvalidArgument, "--trusted-proxy is `" + text + "`",
                "write the proxy's address, or its network: 192.0.2.1, 10.0.0.0/8, ::1");
        const auto length = static_cast<unsigned short>(bits + (found->is_v4() ? mapped_bits : 0));
        out.networks_.push_back(network_v6(as_v6(*found), length).canonical());
    }
    return out;
}

bool TrustedProxies::trusts(const address& given) const {
    const address_v6 who = as_v6(plain_address(given));
    return std::ranges::any_of(networks_, [&](const network_v6& each) {
        return network_v6(who, each.prefix_length()).canonical() == each;
    });
}

address TrustedProxies::client_of(const address& peer,
                                  const std::vector<std::string_view>& forwarded) const {
    address client = plain_address(peer);
    for (auto hop = forwarded.rbegin(); hop != forwarded.rend() && trusts(client); ++hop) {
        const auto next = read_hop(*hop);
        if (!next)
            break;
        client = *next;
    }
    return client;
}

} // namespace wakesurf::server
