// Whom a request comes from behind proxies: only what trusted ones say counts.
#include "server/net/http_message.hpp"
#include "server/net/trusted_proxies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wakesurf::server::trusted_proxies_test {

namespace {

using boost::asio::ip::make_address;
using Is = ProxyHeader::Is;

std::string
client(const TrustedProxies& proxies, const char* peer, const std::vector<std::string>& forwarded) {
    HttpRequest request;
    for (const std::string& each : forwarded)
        request.headers.emplace_back("x-forwarded-for", each);
    return proxies.client_of(make_address(peer), request.list("x-forwarded-for")).to_string();
}

std::string binary(unsigned command, unsigned family, const std::string& addresses) {
    std::string out("\r\n\r\n\0\r\nQUIT\n", 12);
    out += static_cast<char>(0x20 | command);
    out += static_cast<char>(family << 4 | 1);
    out += static_cast<char>(addresses.size() >> 8);
    out += static_cast<char>(addresses.size() & 0xff);
    return out + addresses;
}

} // namespace

TEST(TrustedProxiesTest, AreAddressesOrNetworks) {
    const auto proxies = *TrustedProxies::parse(
        {"192.0.2.1", "10.0.0.0/8", "172.16.0.0/12", "2001:db8::/33", "::1"});
    for (const char* yes : {"192.0.2.1", "10.255.0.1", "172.31.255.255", "2001:db8:7fff::1", "::1",
                            "::ffff:10.1.2.3"})
        EXPECT_TRUE(proxies.trusts(make_address(yes))) << yes;
    for (const char* no :
         {"192.0.2.2", "11.0.0.1", "172.32.0.0", "2001:db8:8000::1", "127.0.0.1", "::2"})
        EXPECT_FALSE(proxies.trusts(make_address(no))) << no;
    EXPECT_FALSE(TrustedProxies().trusts(make_address("127.0.0.1"))) << "no one by itself";
    for (const char* wrong : {"", "proxy", "10.0.0.0/33", "10.0.0.0/", "10.0.0.0/-1", "10.0.0.0/8x",
                              "::/129", "10.0.0/8"})
        EXPECT_FALSE(TrustedProxies::parse({wrong})) << wrong;
}

TEST(TrustedProxiesTest, SayWhoAsksByTheLastAddressThatIsNoneOfThem) {
    const auto proxies = *TrustedProxies::parse({"10.0.0.0/8"});
    EXPECT_EQ(client(proxies, "10.0.0.1", {"203.0.113.7"}), "203.0.113.7");
    EXPECT_EQ(client(proxies, "10.0.0.1", {"1.1.1.1, 203.0.113.7, 10.0.0.2"}), "203.0.113.7");
    EXPECT_EQ(client(proxies, "10.0.0.1", {"1.1.1.1", "203.0.113.7 ,10.0.0.2"}), "203.0.113.7")
        << "several headers are one list";
    EXPECT_EQ(client(proxies, "10.0.0.1", {"203.0.113.7:4711"}), "203.0.113.7");
    EXPECT_EQ(client(proxies, "10.0.0.1", {"\"[2001:db8::7]:4711\""}), "2001:db8::7");
    EXPECT_EQ(client(proxies, "::ffff:10.0.0.1", {"2001:db8::7"}), "2001:db8::7");
    EXPECT_EQ(client(proxies, "10.0.0.1", {"10.0.0.3"}), "10.0.0.3") << "a proxy asks for itself";
}

TEST(TrustedProxiesTest, AreNotSpokenForByAnybodyElse) {
    const auto proxies = *TrustedProxies::parse({"10.0.0.0/8"});
    EXPECT_EQ(client(proxies, "203.0.113.7", {"198.51.100.1"}), "203.0.113.7");
    EXPECT_EQ(client(TrustedProxies(), "127.0.0.1", {"198.51.100.1"}), "127.0.0.1");
    EXPECT_EQ(client(proxies, "10.0.0.1", {}), "10.0.0.1");
    for (const char* nonsense :
         {"", "unknown", "[", "[]", "203.0.113", "a, b", "203.0.113.7, _hidden"})
        EXPECT_EQ(client(proxies, "10.0.0.1", {nonsense}), "10.0.0.1") << nonsense;
}

TEST(ProxyProtocolTest, ReadsBothVersionsByteByByte) {
    const std::string v4("\xcb\x00\x71\x07\x0a\x00\x00\x01\x12\x67\x01\xbb", 12);
    const std::string v6 = std::string("\x20\x01\x0d\xb8", 4) + std::string(11, '\0') + "\x07" +
                           std::string(16, '\0') + "abcd";

    struct Case {
        std::string header;
        std::string from;
    };

    for (const auto& [header, from] :
         {Case{"PROXY TCP4 203.0.113.7 10.0.0.1 4711 443\r\n", "203.0.113.7"},
          Case{"PROXY TCP6 2001:db8::7 ::1 4711 443\r\n", "2001:db8::7"},
          Case{"PROXY UNKNOWN\r\n", ""}, Case{"PROXY UNKNOWN some words\r\n", ""},
          Case{binary(1, 1, v4), "203.0.113.7"}, Case{binary(1, 2, v6), "2001:db8::7"},
          Case{binary(1, 1, v4 + std::string(100, 'x')), "203.0.113.7"}, Case{binary(0, 0, ""), ""},
          Case{binary(1, 3, std::string(216, 'u')), ""}}) {
        for (std::size_t size = 0; size < header.size(); ++size)
            EXPECT_EQ(parse_proxy_header(std::string_view(header).substr(0, size)).is, Is::Partial)
                << header << size;
        const ProxyHeader read = parse_proxy_header(header + "GET / HTTP/1.1\r\n");
        EXPECT_EQ(read.is, Is::Complete) << header;
        EXPECT_EQ(read.length, header.size());
        EXPECT_EQ(read.from ? read.from->to_string() : "", from);
    }
}

TEST(ProxyProtocolTest, TellsOtherProtocolsAndNonsense) {
    for (const char* other : {"GET / HTTP/1.1\r\n", "PRI * HTTP/2.0\r\n", "POST / HTTP/1.1\r\n",
                              "\x16\x03\x01", "proxy TCP4"})
        EXPECT_EQ(parse_proxy_header(other).is, Is::None) << other;
    for (const std::string& nonsense :
         {std::string("PROXY TCP4\r\n"), std::string("PROXY TCP4 203.0.113 10.0.0.1 1 2\r\n"),
          std::string("PROXY TCP6 203.0.113.7 10.0.0.1 1 2\r\n"),
          std::string("PROXY UDP4 203.0.113.7 10.0.0.1 1 2\r\n"),
          "PROXY TCP4 " + std::string(200, '1'), binary(2, 1, std::string(12, 'x')),
          binary(1, 1, "short"), binary(1, 1, std::string(2000, 'x'))})
        EXPECT_EQ(parse_proxy_header(nonsense).is, Is::Malformed) << nonsense;
}

} // namespace wakesurf::server::trusted_proxies_test
