#include "tests/fuzz/json_mutation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace wakesurf::fuzz {

using nlohmann::json;

namespace {

std::size_t below(std::size_t count, std::mt19937& random) {
    return random() % count;
}

// Where the JSON of a text begins that holds it in lines, behind other words: the whole text, or one line.
struct Place {
    std::size_t begin = 0, end = 0;
};

std::optional<std::pair<Place, json>> json_in(std::string_view text, std::mt19937& random) {
    if (json whole = json::parse(text, nullptr, false); !whole.is_discarded())
        return std::pair{Place{0, text.size()}, std::move(whole)};
    std::vector<Place> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (const std::size_t open = text.find_first_of("{[", begin); open < end)
            lines.push_back({open, end});
        begin = end + 1;
    }
    if (lines.empty())
        return std::nullopt;
    const Place line = lines[below(lines.size(), random)];
    json value = json::parse(text.substr(line.begin, line.end - line.begin), nullptr, false);
    if (value.is_discarded())
        return std::nullopt;
    return std::pair{line, std::move(value)};
}

// All values within, itself among them.
std::vector<json*> values_in(json& whole) {
    std::vector<json*> out{&whole};
    for (std::size_t i = 0; i < out.size(); ++i)
        if (json& value = *out[i]; value.is_structured())
            for (json& inner : value)
                out.push_back(&inner);
    return out;
}

json odd_value(std::mt19937& random) {
    static const std::vector<json> odd{
        nullptr,
        true,
        false,
        0,
        -1,
        1,
        -0.0,
        0.5,
        1e-320,
        1e308,
        -1e308,
        2147483648u,
        4294967296u,
        9007199254740993,
        std::numeric_limits<std::int64_t>::min(),
        std::numeric_limits<std::int64_t>::max(),
        std::numeric_limits<std::uint64_t>::max(),
        "",
        "main",
        "../a",
        std::string("a\0b", 3),
        "\xf0\x9f\x98\x80\xcc\x81",
        std::string(300, 'x'),
        json::array(),
        json::object(),
        json::array({0, 0, 0}),
    };
    return odd[below(odd.size(), random)];
}

void change_number(json& number, std::mt19937& random) {
    const double value = number.get<double>();
    const double choices[] = {-value,      value + 1,   value - 1,
                              value * 1e9, value * 0.5, std::nextafter(value, 1e308)};
    const double chosen = choices[below(std::size(choices), random)];
    if (number.is_number_integer() && std::abs(chosen) < 1e15)
        number = static_cast<std::int64_t>(chosen);
    else if (std::isfinite(chosen))
        number = chosen;
}

void change_text(json& text, std::mt19937& random) {
    auto& bytes = text.get_ref<std::string&>();
    const std::size_t at = below(bytes.size() + 1, random);
    switch (below(4, random)) {
    case 0:
        bytes.insert(at, 1, static_cast<char>(below(128, random)));
        break;
    case 1:
        bytes.resize(at);
        break;
    case 2:
        bytes += bytes;
        break;
    default:
        if (at < bytes.size())
            bytes[at] = static_cast<char>(below(128, random));
    }
}

} // namespace

JsonMutation::JsonMutation(const std::vector<std::string>& seeds) {
    std::mt19937 random;
    for (const std::string& seed : seeds)
        if (const auto found = json_in(seed, random))
            collect(found->second);
}

void JsonMutation::collect(const json& value) {
    if (!value.is_structured())
        return;
    for (const auto& [key, inner] : value.items()) {
        donors_.push_back({value.is_object() ? key : std::string(), inner});
        collect(inner);
    }
}

json JsonMutation::any_value(std::mt19937& random) const {
    if (donors_.empty() || below(2, random) == 0)
        return odd_value(random);
    return donors_[below(donors_.size(), random)].value;
}

void JsonMutation::change_here(json& value, std::mt19937& random) const {
    const std::size_t what = below(4, random);
    if (value.is_object() && what == 0 && !value.empty()) {
        value.erase(
            std::next(value.begin(), static_cast<std::ptrdiff_t>(below(value.size(), random))));
    } else if (value.is_object() && what < 3 && !donors_.empty()) {
        const Donor& donor = donors_[below(donors_.size(), random)];
        value[donor.key] = what == 1 ? donor.value : any_value(random);
    } else if (value.is_array() && what == 0 && !value.empty()) {
        value.erase(below(value.size(), random));
    } else if (value.is_array() && what < 3) {
        value.push_back(value.empty() || what == 1 ? any_value(random)
                                                   : json(value[below(value.size(), random)]));
    } else if (value.is_number() && what < 2) {
        change_number(value, random);
    } else if (value.is_string() && what < 2) {
        change_text(value, random);
    } else {
        value = any_value(random);
    }
}

void JsonMutation::change(json& whole, std::mt19937& random) const {
    for (std::size_t round = 1 + below(3, random); round > 0; --round) {
        const auto values = values_in(whole);
        change_here(*values[below(values.size(), random)], random);
    }
}

std::optional<std::string> JsonMutation::operator()(std::string_view text,
                                                    std::mt19937& random) const {
    auto found = json_in(text, random);
    if (!found)
        return std::nullopt;
    auto& [place, value] = *found;
    change(value, random);
    std::string out(text.substr(0, place.begin));
    out += value.dump(-1, ' ', false, json::error_handler_t::replace);
    out += text.substr(place.end);
    return out;
}

} // namespace wakesurf::fuzz
