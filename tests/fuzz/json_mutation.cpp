#include "tests/fuzz/json_mutation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace wakesurf::fuzz {

namespace {

using Kind = JsonSpan::Kind;
using Spans = std::vector<JsonSpan>;

// Where the JSON of a text is that holds it in lines, behind other words: the whole text, or the end of one line.
struct Place {
    std::size_t begin = 0, end = 0;
};

bool is_json(std::string_view text) {
    const auto spans = json_spans(text);
    return spans && text.find_first_not_of(" \t\r\n", spans->front().end) == text.npos;
}

std::optional<Place> place_of_json(std::string_view text, Random& random) {
    if (is_json(text))
        return Place{0, text.size()};
    std::vector<Place> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t open = std::min(text.find('{', begin), text.find('[', begin));
        if (open < end)
            lines.push_back({open, end});
        begin = end + 1;
    }
    if (lines.empty())
        return std::nullopt;
    const Place line = lines[below(lines.size(), random)];
    return is_json(text.substr(line.begin, line.end - line.begin)) ? std::optional(line)
                                                                   : std::nullopt;
}

std::string_view text_of(std::string_view json, const JsonSpan& span) {
    return json.substr(span.begin, span.end - span.begin);
}

// The key with its quotes; empty within an array.
std::string_view key_of(std::string_view json, const JsonSpan& span) {
    const auto before = json.substr(span.key, span.begin - span.key);
    return before.substr(0, before.rfind('"') + 1);
}

std::vector<std::size_t> inner_of(const Spans& spans, std::size_t own) {
    std::vector<std::size_t> out;
    for (std::size_t i = own + 1; i < spans.size() && out.size() < spans[own].inner; ++i)
        if (spans[i].parent == own)
            out.push_back(i);
    return out;
}

const std::string& odd_value(Random& random) {
    static const std::vector<std::string> odd{"null",
                                              "true",
                                              "false",
                                              "0",
                                              "-1",
                                              "1",
                                              "-0.0",
                                              "0.5",
                                              "1e-320",
                                              "1E+308",
                                              "-1e308",
                                              "1e999",
                                              "2147483648",
                                              "4294967296",
                                              "9007199254740993",
                                              "-9223372036854775808",
                                              "9223372036854775807",
                                              "18446744073709551615",
                                              "18446744073709551616",
                                              R"("")",
                                              R"("main")",
                                              R"("../a")",
                                              R"("a\u0000b")",
                                              R"("\ud83d")",
                                              "\"\xf0\x9f\x98\x80\xcc\x81\"",
                                              '"' + std::string(300, 'x') + '"',
                                              "[]",
                                              "{}",
                                              "[0,0,0]"};
    return odd[below(odd.size(), random)];
}

void replace(std::string& json, const JsonSpan& span, std::string_view value) {
    json.replace(span.begin, span.end - span.begin, value);
}

void remove_inner(std::string& json, const Spans& spans, std::size_t own, Random& random) {
    const auto inner = inner_of(spans, own);
    const std::size_t which = below(inner.size(), random);
    const std::size_t begin = which > 0 ? spans[inner[which - 1]].end : spans[inner[which]].key;
    const std::size_t end =
        which > 0 || inner.size() == 1 ? spans[inner[which]].end : spans[inner[which + 1]].key;
    json.erase(begin, end - begin);
}

void append_inner(std::string& json, const JsonSpan& own, std::string value) {
    json.insert(own.end - 1, own.inner > 0 ? "," + value : value);
}

void change_number(std::string& json, const JsonSpan& span, Random& random) {
    double value = 0;
    std::from_chars(json.data() + span.begin, json.data() + span.end, value);
    const double choices[] = {-value,      value + 1,   value - 1,
                              value * 1e9, value * 0.5, std::nextafter(value, 1e308)};
    char text[32];
    const double chosen = choices[below(std::size(choices), random)];
    if (std::isfinite(chosen))
        replace(json, span, {text, std::to_chars(text, std::end(text), chosen).ptr});
}

void change_text(std::string& json, const JsonSpan& span, Random& random) {
    const auto letter = static_cast<char>(' ' + below(95, random));
    const std::size_t at = span.begin + 1 + below(span.end - span.begin - 1, random);
    switch (below(4, random)) {
    case 0:
        json.insert(at, 1, letter);
        break;
    case 1:
        json.erase(at, span.end - 1 - at);
        break;
    case 2:
        json.insert(span.end - 1, json.substr(span.begin + 1, span.end - span.begin - 2));
        break;
    default:
        if (at < span.end - 1)
            json[at] = letter;
    }
}

} // namespace

JsonMutation::JsonMutation(const std::vector<std::string>& seeds) {
    Random random;
    for (const std::string& seed : seeds) {
        const auto place = place_of_json(seed, random);
        if (!place)
            continue;
        const std::string json = seed.substr(place->begin, place->end - place->begin);
        const auto spans = json_spans(json);
        for (const JsonSpan& span : *spans)
            if (span.begin > 0)
                donors_.push_back(
                    {std::string(key_of(json, span)), std::string(text_of(json, span))});
    }
}

const std::string& JsonMutation::any_value(Random& random) const {
    if (donors_.empty() || below(2, random) == 0)
        return odd_value(random);
    return donors_[below(donors_.size(), random)].value;
}

void JsonMutation::put_member(std::string& json,
                              const Spans& spans,
                              std::size_t object,
                              Random& random) const {
    const Donor& donor = donors_[below(donors_.size(), random)];
    const std::string& value = below(2, random) == 0 ? donor.value : any_value(random);
    if (below(16, random) > 0) // else the member may be there twice
        for (const std::size_t i : inner_of(spans, object))
            if (key_of(json, spans[i]) == donor.key)
                return replace(json, spans[i], value);
    append_inner(json, spans[object], (donor.key.empty() ? R"("")" : donor.key) + ':' + value);
}

void JsonMutation::change(std::string& json, Random& random) const {
    const auto spans = json_spans(json);
    if (!spans)
        return; // a change to a text can end it early
    const std::size_t own = below(spans->size(), random);
    const JsonSpan& span = (*spans)[own];
    const std::size_t what = below(4, random);
    if (span.structured() && what == 0 && span.inner > 0)
        remove_inner(json, *spans, own, random);
    else if (span.kind == Kind::Object && what < 3 && !donors_.empty())
        put_member(json, *spans, own, random);
    else if (span.kind == Kind::Array && what == 1 && span.inner > 0)
        append_inner(json, span, std::string(text_of(json, (*spans)[own + 1])));
    else if (span.kind == Kind::Array && what < 3)
        append_inner(json, span, any_value(random));
    else if (span.kind == Kind::Number && what < 2)
        change_number(json, span, random);
    else if (span.kind == Kind::Text && what < 2)
        change_text(json, span, random);
    else
        replace(json, span, any_value(random));
}

std::optional<std::string> JsonMutation::operator()(std::string_view text, Random& random) const {
    const auto place = place_of_json(text, random);
    if (!place)
        return std::nullopt;
    std::string json(text.substr(place->begin, place->end - place->begin));
    for (std::size_t round = 1 + below(3, random); round > 0; --round)
        change(json, random);
    std::string out(text.substr(0, place->begin));
    out += json;
    out += text.substr(place->end);
    return out;
}

} // namespace wakesurf::fuzz
