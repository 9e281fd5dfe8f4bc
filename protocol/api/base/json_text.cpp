#include "protocol/api/base/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <vector>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

/// Follows the text to where it ends to be JSON.
class Follower : public nlohmann::json_sax<json> {
  public:
    bool null() override { return value(); }

    bool boolean(bool) override { return value(); }

    bool number_integer(json::number_integer_t) override { return value(); }

    bool number_unsigned(json::number_unsigned_t) override { return value(); }

    bool number_float(json::number_float_t, const std::string&) override { return value(); }

    bool string(std::string&) override { return value(); }

    bool binary(json::binary_t&) override { return value(); }

    bool start_object(std::size_t) override {
        at_.push_back({});
        return true;
    }

    bool key(std::string& name) override {
        at_.back().name = name;
        return member(at_.back().names, name);
    }

    bool end_object() override { return end(); }

    bool start_array(std::size_t) override {
        at_.push_back({{}, 0});
        return true;
    }

    bool end_array() override { return end(); }

    bool parse_error(std::size_t position,
                     const std::string&,
                     const nlohmann::detail::exception& error) override {
        position_ = position;
        in_text_ = std::string_view(error.what()).find("invalid string") != std::string_view::npos;
        too_large_ = error.id == 406; // of the library: a number that overflows
        return false;
    }

    std::size_t position() const { return position_; }

    bool too_large() const { return too_large_; }

    /// It ends amid a text in quotes.
    bool in_text() const { return in_text_; }

    /// `points[3][1]`; of a call's parameters without what leads to them.
    std::string place() const {
        std::string out;
        for (const Level& each : at_)
            if (each.index >= 0)
                out += fmt::format("[{}]", each.index);
            else if (!each.name.empty())
                out += (out.empty() ? "" : ".") + each.name.substr(0, 64);
        for (const std::string_view leading : {"params.", "error.", "result."})
            if (const auto found = out.find(leading); found != std::string::npos)
                return out.substr(found + leading.size());
        return out;
    }

  protected:
    using Names = std::set<std::string>;

    virtual bool member(Names&, const std::string&) { return true; }

  private:
    struct Level {
        std::string name;
        int index = -1; ///< of an array's next element
        Names names{};  ///< of an object, where they are collected
    };

    bool value() {
        if (!at_.empty() && at_.back().index >= 0)
            ++at_.back().index;
        return true;
    }

    bool end() {
        at_.pop_back();
        return value();
    }

    std::vector<Level> at_;
    std::size_t position_ = 0;
    bool too_large_ = false;
    bool in_text_ = false;
};

/// Follows it to a member whose object has had it already.
class TwiceFinder final : public Follower {
    bool member(Names& names, const std::string& name) override {
        return names.insert(name).second;
    }
};

/// Returns what languages print for numbers that JSON has not: the one whose letters `position` is among.
std::string_view no_number(std::string_view text, std::size_t position) {
    constexpr std::array<std::string_view, 5> words{"-Infinity", "Infinity", "NaN", "-inf", "inf"};
    const auto letter = [](char c) {
        return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '-';
    };
    std::size_t first = std::min(position, text.size());
    while (first > 0 && letter(text[first - 1]))
        --first;
    std::size_t last = first;
    while (last < text.size() && letter(text[last]))
        ++last;
    const std::string_view found = text.substr(first, last - first);
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return std::ranges::any_of(words,
                               [&](auto word) { return std::ranges::equal(word, found, same); })
               ? found
               : std::string_view{};
}

} // namespace

JsonFault json_fault(std::string_view text) {
    Follower follower;
    json::sax_parse(text, &follower);
    // The parser has read one letter more than it takes.
    const std::size_t position = follower.position() > 0 ? follower.position() - 1 : 0;
    const std::string place = follower.place();
    const std::string where = place.empty() ? std::string("the text") : "`" + place + "`";
    if (follower.too_large())
        return {where + " is beyond 1.8e308, the largest number there is", "send a finite number"};
    if (const auto word = no_number(text, position); !word.empty() && !follower.in_text())
        return {fmt::format("{} is {}, which JSON cannot represent", where, word),
                "send a finite number, or leave it out where there is none"};
    return {fmt::format("the text is not valid JSON from byte {} on{}", position,
                        place.empty() ? "" : ", in " + where),
            "send JSON text in UTF-8"};
}

JsonFault member_twice(std::string_view text) {
    TwiceFinder finder;
    json::sax_parse(text, &finder);
    return {fmt::format("`{}` appears twice", finder.place()), "send each member once"};
}

namespace {

struct Shape {
    std::size_t deepest = 0;
    std::size_t values = 1;  ///< at most so many
    std::size_t members = 0; ///< of all objects
};

Shape shape_of(std::string_view text) {
    Shape shape;
    std::size_t depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            i += c == '\\' ? 1 : 0;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            shape.deepest = std::max(shape.deepest, ++depth);
            ++shape.values;
        } else if (c == ',') {
            ++shape.values;
        } else if (c == ':') {
            ++shape.members;
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return shape;
}

/// Where a member comes twice there are fewer of them than in the text.
std::size_t members_of(const nlohmann::json& value) {
    if (!value.is_structured())
        return 0;
    std::size_t members = value.is_object() ? value.size() : 0;
    for (const auto& each : value)
        members += members_of(each);
    return members;
}

} // namespace

core::Result<nlohmann::json> parse_json(std::string_view text, JsonLimits limits) {
    using core::Error;
    if (text.size() > limits.bytes)
        return core::fail(Error::Code::OverLimit, "the JSON text is longer than " +
                                                      std::to_string(limits.bytes) + " bytes");
    const Shape shape = shape_of(text);
    if (shape.deepest > limits.depth)
        return core::fail(Error::Code::OverLimit, "the JSON text is nested deeper than " +
                                                      std::to_string(limits.depth) + " levels");
    if (shape.values > limits.values)
        return core::fail(Error::Code::OverLimit, "the JSON text has more than " +
                                                      std::to_string(limits.values) + " values");
    auto value = nlohmann::json::parse(text, nullptr, false);
    if (value.is_discarded()) {
        JsonFault fault = json_fault(text);
        return core::fail(Error::Code::Corrupt, std::move(fault.message), std::move(fault.hint));
    }
    if (members_of(value) != shape.members) {
        JsonFault fault = member_twice(text);
        return core::fail(Error::Code::InvalidArgument, std::move(fault.message),
                          std::move(fault.hint));
    }
    return value;
}

std::string json_text(const nlohmann::json& value, int indent) {
    return value.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace wakesurf::protocol
