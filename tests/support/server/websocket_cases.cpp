#include "tests/support/server/websocket_cases.hpp"

#include <fmt/format.h>

#include <utility>

namespace wakesurf::tests::ws {

namespace {

Expected echo(std::string id) {
    return {Expected::Kind::Echo, std::move(id), 0};
}

/// The standard lets a server that ends a connection drop what it has not sent yet.
Expected echo_if_sent(std::string id) {
    return {Expected::Kind::EchoIfSent, std::move(id), 0};
}

Expected answer(std::string ponged) {
    return {Expected::Kind::Pong, std::move(ponged), 0};
}

Expected close_with(unsigned code) {
    return {Expected::Kind::Close, {}, code};
}

const Expected no_json{Expected::Kind::ParseError, {}, 0};

std::string whole(const std::string& payload) {
    return frame(fin | text, payload);
}

/// Returns a text message in frames of at most `size` bytes.
std::string in_fragments(const std::string& payload, std::size_t size) {
    std::string bytes;
    for (std::size_t at = 0; at < payload.size(); at += size)
        bytes += frame((at == 0 ? text : continuation) | (at + size >= payload.size() ? fin : 0),
                       payload.substr(at, size));
    return bytes;
}

void lengths(Cases& cases) {
    for (const std::size_t size :
         {64u, 124u, 125u, 126u, 127u, 128u, 1023u, 1024u, 1025u, 32768u, 65534u, 65535u, 65536u})
        for (const std::size_t chunk : {0u, 997u})
            cases.push_back({fmt::format("1_text_of_{}_bytes_sent_by_{}", size, chunk),
                             whole(call("one", size)),
                             {echo("one")},
                             chunk});
    cases.push_back({"1_empty_text", whole(""), {no_json}});
    cases.push_back({"1_long_form_of_two_bytes_for_a_short_length",
                     frame(fin | text, "{}", Length::Two),
                     {close_with(1002)}});
    cases.push_back({"1_long_form_of_eight_bytes_for_a_short_length",
                     frame(fin | text, "{}", Length::Eight),
                     {close_with(1002)}});
    cases.push_back({"1_long_form_of_eight_bytes_for_a_length_of_two",
                     frame(fin | text, std::string(300, ' '), Length::Eight),
                     {close_with(1002)}});
    cases.push_back({"1_binary", frame(fin | binary, "draco"), {close_with(1003)}});
    cases.push_back({"1_binary_empty", frame(fin | binary, ""), {close_with(1003)}});
    cases.push_back({"1_unmasked", std::string("\x81\x02{}", 4), {close_with(1002)}});
    cases.push_back({"1_unmasked_ping", std::string("\x89\x00", 2), {close_with(1002)}});
}

void pings(Cases& cases) {
    const std::string every_byte = [] {
        std::string bytes;
        for (int i = 0; i < 125; ++i)
            bytes += static_cast<char>(255 - i);
        return bytes;
    }();
    for (const std::string& payload :
         {std::string(), std::string("Hello"), std::string("\x00\xff\xfe\xfd\xfc\xfb\x00\xff", 8),
          std::string(125, '*'), every_byte})
        for (const std::size_t chunk : {0u, 1u})
            cases.push_back({fmt::format("2_ping_of_{}_bytes_from_{}_sent_by_{}", payload.size(),
                                         payload.empty() ? 0 : payload[0] & 0xff, chunk),
                             frame(fin | ping, payload),
                             {answer(payload)},
                             chunk});
    for (const std::size_t size : {126u, 127u, 1000u})
        cases.push_back({fmt::format("2_ping_of_{}_bytes", size),
                         frame(fin | ping, std::string(size, 'p')),
                         {close_with(1002)}});
    cases.push_back({"2_pong_that_no_one_asked_for", frame(fin | pong, "unsolicited"), {}});
    cases.push_back({"2_empty_pong_that_no_one_asked_for", frame(fin | pong, ""), {}});
    cases.push_back(
        {"2_pong_then_ping", frame(fin | pong, "a") + frame(fin | ping, "b"), {answer("b")}});
    std::string ten;
    std::vector<Expected> pongs;
    for (int i = 0; i < 10; ++i) {
        ten += frame(fin | ping, fmt::format("payload-{}", i));
        pongs.push_back(answer(fmt::format("payload-{}", i)));
    }
    cases.push_back({"2_ten_pings", ten, pongs});
    cases.push_back({"2_ten_pings_byte_by_byte", ten, pongs, 1});
}

void reserved_bits(Cases& cases) {
    for (const int bits : {0x10, 0x20, 0x30, 0x40, 0x50, 0x60, 0x70})
        for (const auto& [name, opcode] : std::vector<std::pair<std::string, int>>{
                 {"text", text}, {"ping", ping}, {"pong", pong}, {"close", closing}})
            cases.push_back({fmt::format("3_reserved_bits_{:02x}_on_{}", bits, name),
                             frame(fin | bits | opcode,
                                   opcode == closing ? close_payload(1000) : std::string("{}")),
                             {close_with(1002)}});
    cases.push_back({"3_a_call_then_a_reserved_bit_then_a_ping",
                     whole(call("before")) + frame(fin | 0x40 | text, "{}") + frame(fin | ping, ""),
                     {echo_if_sent("before"), close_with(1002)}});
    cases.push_back({"3_a_reserved_bit_on_a_continuation",
                     frame(text, "{") + frame(fin | 0x40 | continuation, "}"),
                     {close_with(1002)}});
}

void opcodes(Cases& cases) {
    for (const int opcode : {3, 4, 5, 6, 7, 11, 12, 13, 14, 15}) {
        cases.push_back({fmt::format("4_opcode_{}_empty", opcode),
                         frame(fin | opcode, ""),
                         {close_with(1002)}});
        cases.push_back({fmt::format("4_opcode_{}_with_payload", opcode),
                         frame(fin | opcode, "what is this"),
                         {close_with(1002)}});
        cases.push_back({fmt::format("4_opcode_{}_after_a_call", opcode),
                         whole(call("a")) + frame(fin | opcode, "x") + frame(fin | ping, ""),
                         {echo_if_sent("a"), close_with(1002)}});
        cases.push_back({fmt::format("4_opcode_{}_within_a_message", opcode),
                         frame(text, "{") + frame(fin | opcode, "x"),
                         {close_with(1002)}});
    }
}

void fragments(Cases& cases) {
    const std::string message = call("fragmented");
    const std::string first = message.substr(0, 20), second = message.substr(20);
    const std::string start = frame(text, first), end = frame(fin | continuation, second);
    for (const std::size_t chunk : {0u, 1u}) {
        const std::string by = fmt::format("_sent_by_{}", chunk);
        cases.push_back({"5_two_fragments" + by, start + end, {echo("fragmented")}, chunk});
        cases.push_back({"5_a_ping_between_fragments" + by,
                         start + frame(fin | ping, "now") + end,
                         {answer("now"), echo("fragmented")},
                         chunk});
        cases.push_back({"5_a_pong_between_fragments" + by,
                         start + frame(fin | pong, "now") + end,
                         {echo("fragmented")},
                         chunk});
        cases.push_back({"5_empty_fragments_between" + by,
                         start + frame(continuation, "") + frame(continuation, "") + end,
                         {echo("fragmented")},
                         chunk});
        cases.push_back(
            {"5_an_empty_first_and_last_fragment" + by,
             frame(text, "") + frame(continuation, message) + frame(fin | continuation, ""),
             {echo("fragmented")},
             chunk});
        cases.push_back({"5_pings_between_five_fragments" + by,
                         frame(text, message.substr(0, 5)) + frame(fin | ping, "1") +
                             frame(continuation, message.substr(5, 5)) + frame(fin | ping, "2") +
                             frame(continuation, message.substr(10, 5)) + frame(fin | ping, "3") +
                             frame(fin | continuation, message.substr(15)),
                         {answer("1"), answer("2"), answer("3"), echo("fragmented")},
                         chunk});
        cases.push_back({"5_a_continuation_of_nothing" + by,
                         frame(fin | continuation, "{}"),
                         {close_with(1002)},
                         chunk});
        cases.push_back({"5_an_unfinished_continuation_of_nothing" + by,
                         frame(continuation, "{}"),
                         {close_with(1002)},
                         chunk});
        cases.push_back({"5_a_continuation_after_a_whole_message" + by,
                         whole(call("a")) + frame(fin | continuation, "{}"),
                         {echo_if_sent("a"), close_with(1002)},
                         chunk});
        cases.push_back({"5_a_message_within_a_message" + by,
                         start + whole(call("b")),
                         {close_with(1002)},
                         chunk});
        cases.push_back({"5_an_unfinished_message_within_a_message" + by,
                         start + start,
                         {close_with(1002)},
                         chunk});
        cases.push_back({"5_a_binary_message_within_a_message" + by,
                         start + frame(fin | binary, "b"),
                         {close_with(1002)},
                         chunk});
        cases.push_back({"5_binary_in_fragments" + by,
                         frame(binary, "dr") + frame(fin | continuation, "aco"),
                         {close_with(1003)},
                         chunk});
    }
    for (const int opcode : {ping, pong, closing})
        cases.push_back({fmt::format("5_opcode_{}_in_fragments", opcode),
                         frame(opcode, opcode == closing ? close_payload(1000) : std::string("x")) +
                             frame(fin | continuation, "y"),
                         {close_with(1002)}});
    for (const std::size_t size : {1u, 2u, 3u, 7u, 64u})
        cases.push_back({fmt::format("5_fragments_of_{}_bytes", size),
                         in_fragments(message, size),
                         {echo("fragmented")}});
    cases.push_back(
        {"5_a_thousand_fragments", in_fragments(call("many", 1000), 1), {echo("many")}});
}

/// Sequences of Markus Kuhn's UTF-8 decoder stress test, as ids.
void utf8(Cases& cases) {
    const std::vector<std::pair<std::string, std::string>> good{
        {"greek", "\xce\xba\xe1\xbd\xb9\xcf\x83\xce\xbc\xce\xb5"},
        {"first_of_two_bytes", "\xc2\x80"},
        {"first_of_three_bytes", "\xe0\xa0\x80"},
        {"first_of_four_bytes", "\xf0\x90\x80\x80"},
        {"last_of_one_byte", "\x7f"},
        {"last_of_two_bytes", "\xdf\xbf"},
        {"last_of_three_bytes", "\xef\xbf\xbf"},
        {"last_of_four_bytes", "\xf4\x8f\xbf\xbf"},
        {"before_the_surrogates", "\xed\x9f\xbf"},
        {"behind_the_surrogates", "\xee\x80\x80"},
        {"replacement_character", "\xef\xbf\xbd"},
        {"byte_order_mark_within", "a\xef\xbb\xbf"
                                   "b"},
        {"non_character_fffe", "\xef\xbf\xbe"},
        {"non_character_1fffe", "\xf0\x9f\xbf\xbe"},
        {"non_character_1ffff", "\xf0\x9f\xbf\xbf"},
        {"non_character_8fffe", "\xf2\x8f\xbf\xbe"},
        {"non_character_10fffe", "\xf4\x8f\xbf\xbe"},
    };
    for (const auto& [name, id] : good) {
        cases.push_back({"6_good_" + name, whole(call(id)), {echo(id)}});
        cases.push_back({"6_good_" + name + "_in_fragments_of_one_byte",
                         in_fragments(call(id), 1),
                         {echo(id)}});
    }
    std::vector<std::pair<std::string, std::string>> bad{
        {"continuation_first", "\x80"},
        {"continuation_last", "\xbf"},
        {"two_continuations", "\x80\xbf"},
        {"seven_continuations", "\x80\xbf\x80\xbf\x80\xbf\x80"},
        {"fe", "\xfe"},
        {"ff", "\xff"},
        {"fe_fe_ff_ff", "\xfe\xfe\xff\xff"},
        {"overlong_slash_in_two", "\xc0\xaf"},
        {"overlong_slash_in_three", "\xe0\x80\xaf"},
        {"overlong_slash_in_four", "\xf0\x80\x80\xaf"},
        {"overlong_slash_in_five", "\xf8\x80\x80\x80\xaf"},
        {"overlong_slash_in_six", "\xfc\x80\x80\x80\x80\xaf"},
        {"overlong_most_in_two", "\xc1\xbf"},
        {"overlong_most_in_three", "\xe0\x9f\xbf"},
        {"overlong_most_in_four", "\xf0\x8f\xbf\xbf"},
        {"overlong_nul_in_two", "\xc0\x80"},
        {"overlong_nul_in_three", "\xe0\x80\x80"},
        {"overlong_nul_in_four", "\xf0\x80\x80\x80"},
        {"last_missing_of_two", "\xc2"
                                "x"},
        {"last_missing_of_three", "\xe2\x82"
                                  "x"},
        {"last_missing_of_four", "\xf0\x9f\x98"
                                 "x"},
        {"two_missing_of_four", "\xf0\x9f"
                                "x"},
        {"surrogate_d800", "\xed\xa0\x80"},
        {"surrogate_db7f", "\xed\xad\xbf"},
        {"surrogate_db80", "\xed\xae\x80"},
        {"surrogate_dbff", "\xed\xaf\xbf"},
        {"surrogate_dc00", "\xed\xb0\x80"},
        {"surrogate_df80", "\xed\xbe\x80"},
        {"surrogate_dfff", "\xed\xbf\xbf"},
        {"surrogate_pair", "\xed\xa0\x80\xed\xb0\x80"},
        {"surrogate_pair_last", "\xed\xaf\xbf\xed\xbf\xbf"},
        {"above_the_last", "\xf4\x90\x80\x80"},
        {"far_above_the_last", "\xf7\xbf\xbf\xbf"},
        {"first_of_five_bytes", "\xf8\x88\x80\x80\x80"},
        {"first_of_six_bytes", "\xfc\x84\x80\x80\x80\x80"},
    };
    for (const int lead :
         {0xc0, 0xc1, 0xc2, 0xdf, 0xe0, 0xed, 0xef, 0xf0, 0xf4, 0xf5, 0xf7, 0xf8, 0xfb, 0xfc, 0xfd})
        bad.emplace_back(fmt::format("lone_{:02x}", lead),
                         std::string(1, static_cast<char>(lead)) + " ");
    for (const auto& [name, id] : bad) {
        cases.push_back({"6_bad_" + name, whole(call(id)), {close_with(1007)}});
        cases.push_back({"6_bad_" + name + "_in_fragments_of_one_byte",
                         in_fragments(call(id), 1),
                         {close_with(1007)}});
    }
    // Bytes that cannot become UTF-8 are refused before the message ends.
    cases.push_back(
        {"6_bad_in_a_first_fragment_with_no_end", frame(text, "\"\xff"), {close_with(1007)}});
    cases.push_back({"6_bad_in_a_frame_that_has_not_ended",
                     head(fin | text, 100) + frame(fin | text, "\"\xff\xff").substr(6),
                     {close_with(1007)}});
    cases.push_back({"6_cut_off_at_the_end", whole("\"\xe2\x82"), {close_with(1007)}});
    for (std::size_t cut = 46; cut < 52; ++cut) {
        const std::string message = call("\xf0\x9f\x98\x80\xe2\x82\xac");
        cases.push_back({fmt::format("6_good_cut_at_{}", cut),
                         frame(text, message.substr(0, cut)) + frame(fin | ping, "p") +
                             frame(fin | continuation, message.substr(cut)),
                         {answer("p"), echo("\xf0\x9f\x98\x80\xe2\x82\xac")}});
    }
}

void closes(Cases& cases) {
    const std::string after = whole(call("late")) + frame(fin | ping, "late");
    cases.push_back({"7_close", frame(fin | closing, close_payload(1000)), {close_with(1000)}});
    cases.push_back(
        {"7_close_byte_by_byte", frame(fin | closing, close_payload(1000)), {close_with(1000)}, 1});
    cases.push_back(
        {"7_two_closes",
         frame(fin | closing, close_payload(1000)) + frame(fin | closing, close_payload(1000)),
         {close_with(1000)}});
    cases.push_back({"7_a_call_then_a_close",
                     whole(call("a")) + frame(fin | closing, close_payload(1000)),
                     {echo_if_sent("a"), close_with(1000)}});
    cases.push_back({"7_nothing_is_answered_behind_a_close",
                     frame(fin | closing, close_payload(1000)) + after,
                     {close_with(1000)}});
    cases.push_back({"7_a_close_within_a_message",
                     frame(text, "{") + frame(fin | closing, close_payload(1000)),
                     {close_with(1000)}});
    cases.push_back({"7_a_close_without_a_code", frame(fin | closing, ""), {close_with(1000)}});
    cases.push_back({"7_a_close_of_one_byte", frame(fin | closing, "\x03"), {close_with(1002)}});
    for (const std::size_t reason : {1u, 122u, 123u})
        cases.push_back({fmt::format("7_a_reason_of_{}_bytes", reason),
                         frame(fin | closing, close_payload(1000, std::string(reason, 'r'))),
                         {close_with(1000)}});
    cases.push_back({"7_a_reason_of_124_bytes",
                     frame(fin | closing, close_payload(1000, std::string(124, 'r'))),
                     {close_with(1002)}});
    cases.push_back({"7_a_reason_that_is_not_UTF_8",
                     frame(fin | closing, close_payload(1000, "\xce\xba\xe1\xbd\xb9\xff")),
                     {close_with(1002)}});
    for (const unsigned code : {1000u, 1001u, 1002u, 1003u, 1007u, 1008u, 1009u, 1010u, 1011u,
                                1012u, 1013u, 3000u, 3999u, 4000u, 4999u})
        cases.push_back({fmt::format("7_code_{}", code),
                         frame(fin | closing, close_payload(code)),
                         {close_with(code)}});
    for (const unsigned code :
         {0u, 1u, 999u, 1004u, 1005u, 1006u, 1015u, 1016u, 1100u, 2000u, 2999u})
        cases.push_back({fmt::format("7_code_{}_is_no_code", code),
                         frame(fin | closing, close_payload(code)),
                         {close_with(1002)}});
}

void limits(Cases& cases) {
    const std::string spaces(65537, ' ');
    cases.push_back({"9_one_byte_too_long", whole(spaces), {close_with(1009)}});
    cases.push_back(
        {"9_one_byte_too_long_in_fragments",
         frame(text, spaces.substr(537)) + frame(fin | continuation, spaces.substr(0, 537)),
         {close_with(1009)}});
    cases.push_back(
        {"9_too_long_in_fragments_of_1_KiB", in_fragments(spaces, 1024), {close_with(1009)}});
    // An announcement alone is enough: the server does not wait for bytes that it could not take.
    for (const std::uint64_t size :
         {std::uint64_t{2} << 20, std::uint64_t{1} << 32, std::uint64_t{1} << 62,
          (std::uint64_t{1} << 63) - 1, std::uint64_t{1} << 63, ~std::uint64_t{0}})
        cases.push_back({fmt::format("9_the_announcement_of_{}_bytes", size),
                         head(fin | text, size),
                         {close_with(1009)}});
    cases.push_back(
        {"9_fragments_announced_beyond_the_limit",
         frame(text, std::string(40000, ' ')) + head(fin | continuation, std::uint64_t{2} << 20),
         {close_with(1009)}});
}

void cut_up(Cases& cases) {
    std::string bytes;
    std::vector<Expected> expected;
    for (int i = 0; i < 12; ++i) {
        bytes += whole(call(fmt::format("id{}", i), 30u + 90u * static_cast<unsigned>(i)));
        expected.push_back(echo(fmt::format("id{}", i)));
    }
    for (const std::size_t chunk : {0u, 1u, 2u, 3u, 5u, 7u, 64u, 125u, 126u, 127u, 1024u, 1460u})
        cases.push_back({fmt::format("10_twelve_calls_sent_by_{}", chunk), bytes, expected, chunk});
}

} // namespace

std::string call(const std::string& id, std::size_t size) {
    std::string words = R"({"jsonrpc":"2.0","method":"server.ping","id":")" + id + "\"}";
    if (words.size() < size)
        words += std::string(size - words.size(), ' ');
    return words;
}

Cases all_cases() {
    Cases cases;
    for (auto* const section :
         {lengths, pings, reserved_bits, opcodes, fragments, utf8, closes, limits, cut_up})
        section(cases);
    return cases;
}

} // namespace wakesurf::tests::ws
