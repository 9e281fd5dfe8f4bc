#include "protocol/api/base/json_members.hpp"

#include "protocol/api/base/json_text.hpp"
#include "protocol/api/base/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace wakesurf::protocol {

using nlohmann::json;

JsonReader::JsonReader(const json& object, bool call) : object_(object), call_(call) {
    if (!object.is_object())
        fault_ = call ? "`params` must be an object: parameters have names" : "must be an object";
}

const json* JsonReader::find(const char* name, const Rule& rule, bool nullable) {
    known_.emplace_back(name);
    if (!fault_.empty())
        return nullptr;
    const auto found = object_.find(name);
    if (found != object_.end() && (nullable || !found->is_null()))
        return &*found;
    if (rule.needed)
        check(name, fmt::format("is missing{}", rule.if_missing));
    return nullptr;
}

void JsonReader::check(std::string_view name, std::string_view wrong) {
    if (fault_.empty() && !wrong.empty())
        fault_ = fmt::format("`{}` {}", name, wrong);
}

core::Result<void> JsonReader::verdict() {
    for (const auto& [name, value] : object_.items())
        if (call_ && fault_.empty() && std::ranges::find(known_, name) == known_.end()) {
            check(name.substr(0, 64), "is not a parameter of this method");
            const std::string meant = nearest_name(name, known_);
            hint_ = meant.empty() ? there_is(known_) : "did you mean `" + meant + "`?";
        }
    if (fault_.empty())
        return {};
    using Code = core::Error::Code;
    return core::fail(call_ ? Code::InvalidArgument : Code::Corrupt, fault_, hint_);
}

std::string JsonReader::wrong_inside(JsonReader& in) {
    const auto sound = in.verdict();
    if (sound)
        return {};
    hint_ = sound.error().hint;
    return (call_ ? "is invalid: " : "") + sound.error().message;
}

JsonWriter::JsonWriter(json& to, bool kept) : to_(to), kept_(kept) {
    if (to.is_null())
        to = json::object();
}

json& JsonWriter::member(const char* name) {
    return to_[name];
}

namespace {

constexpr double largest_exact = most_whole;

bool has_limit(const Rule& rule) {
    return rule.hi < no_limit;
}

/// Returns nothing for other types, fractions, and what the type does not hold. 3.0 is a whole number, as in
/// JSON Schema.
template <class Whole>
std::optional<Whole> whole(const json& value) {
    const auto fitting = [](auto number) {
        return std::in_range<Whole>(number) ? std::optional(static_cast<Whole>(number))
                                            : std::nullopt;
    };
    if (value.is_number_unsigned()) // text holds unsigned numbers, C++ code signed ones
        return fitting(value.get<std::uint64_t>());
    if (value.is_number_integer())
        return fitting(value.get<std::int64_t>());
    const auto number = value.is_number() ? value.get<double>() : 0.5;
    if (std::abs(number) > largest_exact || number != std::floor(number))
        return std::nullopt;
    return fitting(static_cast<std::int64_t>(number));
}

template <class Whole>
std::string read_whole(const json& from, Whole& to, const Rule& rule) {
    const auto bound = [](double of, Whole otherwise) {
        return std::abs(of) <= largest_exact ? static_cast<Whole>(of) : otherwise;
    };
    const Whole lo = bound(rule.lo, std::numeric_limits<Whole>::min());
    const Whole hi = bound(rule.hi, std::numeric_limits<Whole>::max());
    const auto number = whole<Whole>(from);
    if (!number || *number < lo || *number > hi)
        return fmt::format("must be a whole number between {} and {}", lo, hi);
    to = *number;
    return {};
}

/// Checks a text, which has the form that its rule says.
std::string wrong_text(const std::string& text, const Rule& rule) {
    const bool lines = rule.text == Text::Lines;
    const auto refused = [&](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && !(lines && (c == '\n' || c == '\t'))) ||
               c == 0x7f;
    };
    if (static_cast<double>(text.size()) > rule.hi || std::ranges::any_of(text, refused))
        return lines ? fmt::format("must be text of at most {} bytes; of control characters it may "
                                   "only have line breaks and tabs",
                                   rule.hi)
                     : fmt::format("must be at most {} bytes without control characters", rule.hi);
    const bool may_be_empty = rule.lo <= 0.0;
    if (rule.text == Text::Colour && !(may_be_empty && text.empty()) && !is_colour(text))
        return "must be written #rrggbb";
    if (!may_be_empty && text.empty())
        return rule.needed ? "must not be empty" : "must not be empty: leave it out";
    const auto last = std::ranges::find(rule.choices, std::string_view());
    const std::span<const std::string_view> choices(rule.choices.begin(), last);
    return choices.empty() || std::ranges::find(choices, text) != choices.end() ? std::string()
                                                                                : must_be(choices);
}

} // namespace

std::string must_be(std::span<const std::string_view> words) {
    return fmt::format("must be {} or {}", fmt::join(words.first(words.size() - 1), ", "),
                       words.back());
}

std::string read_value(const json& from, json& to, const Rule&, JsonReader&) {
    to = from;
    return {};
}

std::string read_value(const json& from, bool& to, const Rule&, JsonReader&) {
    if (!from.is_boolean())
        return "must be true or false";
    to = from.get<bool>();
    return {};
}

std::string read_value(const json& from, double& to, const Rule& rule, JsonReader&) {
    to = from.is_number() ? from.get<double>() : NAN;
    if (!std::isfinite(to) || to < rule.lo || to > rule.hi) {
        if (has_limit(rule))
            return fmt::format("must be a number between {} and {}", rule.lo, rule.hi);
        return rule.lo <= -no_limit ? "must be a finite number"
                                    : fmt::format("must be a finite number from {}", rule.lo);
    }
    return rule.above_zero && to <= 0.0 ? "must be a number greater than 0" : std::string();
}

std::string read_value(const json& from, std::uint64_t& to, const Rule& rule, JsonReader&) {
    return read_whole(from, to, rule);
}

std::string read_value(const json& from, std::int64_t& to, const Rule& rule, JsonReader&) {
    return read_whole(from, to, rule);
}

std::string read_value(const json& from, std::string& to, const Rule& rule, JsonReader&) {
    switch (rule.text) {
    case Text::Object:
        to = from.is_object() ? json_text(from) : std::string();
        return !to.empty() && static_cast<double>(to.size()) <= rule.hi
                   ? std::string()
                   : fmt::format("must be an object of at most {} bytes of JSON text", rule.hi);
    case Text::Token:
    case Text::WholeToken:
        to = json_text(from);
        if (from.is_string() || from.is_number_integer() ||
            (from.is_number() && rule.text == Text::Token))
            return {};
        return rule.text == Text::Token ? "must be a string or a number"
                                        : "must be a string or a whole number";
    default:
        if (!from.is_string())
            return rule.text == Text::Lines ? wrong_text("\r", rule) : "must be a string";
        to = from.get<std::string>();
        return rule.text == Text::Any ? std::string() : wrong_text(to, rule);
    }
}

std::string read_value(const json& from, core::Vec3& to, const Rule& rule, JsonReader&) {
    const auto coordinate = [&](const json& each) {
        return each.is_number() && std::abs(each.get<double>()) <= rule.hi;
    };
    if (!from.is_array() || from.size() != 3 || !std::ranges::all_of(from, coordinate))
        return "must be three finite numbers [x,y,z]";
    to = {from[0].get<double>(), from[1].get<double>(), from[2].get<double>()};
    return {};
}

std::string read_value(const json& from, core::Box& to, const Rule&, JsonReader& in) {
    std::array<double, 6> ends{};
    std::string wrong = read_list(from, ends, in);
    to = {{ends[0], ends[2], ends[4]}, {ends[1], ends[3], ends[5]}};
    return wrong;
}

std::string read_value(const json& from, std::array<double, 2>& to, const Rule&, JsonReader& in) {
    if (from != json{nullptr, nullptr})
        return read_list(from, to, in);
    to.fill(NAN);
    return {};
}

std::string
read_value(const json& from, std::vector<core::Vec3>& to, const Rule& rule, JsonReader& in) {
    if (!from.is_array() || static_cast<double>(from.size()) > rule.hi)
        return has_limit(rule) ? fmt::format("must be a list of at most {} points [x,y,z]", rule.hi)
                               : "must be a list";
    to.resize(from.size());
    for (std::size_t i = 0; i < to.size(); ++i)
        if (!read_value(from[i], to[i], Rule{.hi = largest_float}, in).empty())
            return fmt::format("must hold points of three finite numbers; point {} is not one", i);
    return {};
}

std::string
read_value(const json& from, std::vector<std::string>& to, const Rule& rule, JsonReader& in) {
    std::string wrong = read_list(from, to, in);
    return has_limit(rule) && (!wrong.empty() || static_cast<double>(to.size()) > rule.hi)
               ? fmt::format("must be a list of at most {} names", rule.hi)
               : wrong;
}

void write_value(json& to, const json& value, const Rule&) {
    to = value;
}

void write_value(json& to, const std::string& value, const Rule& rule) {
    to = rule.text == Text::Object ? json::parse(value) : json(value);
}

void write_value(json& to, const core::Vec3& value, const Rule&) {
    to = {value.x, value.y, value.z};
}

void write_value(json& to, const core::Box& value, const Rule&) {
    const auto& [lo, hi] = value;
    to = {lo.x, hi.x, lo.y, hi.y, lo.z, hi.z};
}

} // namespace wakesurf::protocol
