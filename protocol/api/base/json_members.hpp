// Structs <-> JSON objects. A struct lists its members once, in a function members(io, struct), with the rule
// of each; JsonReader takes calls and what is kept by that list, JsonWriter writes answers and what is kept.
// Only source files include the JSON library.
#pragma once

#include "core/base/box.hpp"
#include "core/base/result.hpp"
#include "protocol/api/base/enum_words.hpp"

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace wakesurf::protocol {

/// A parameter of which null says something else than leaving it out.
/// Given without a value: null.
template <class T>
struct Nullable {
    bool given = false;
    std::optional<T> value;

    bool operator==(const Nullable&) const = default;
};

/// Colours, as they are written in messages and records.
/// #rrggbb
constexpr bool is_colour(std::string_view text) {
    const auto digit = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    return text.size() == 7 && text.front() == '#' &&
           std::all_of(text.begin() + 1, text.end(), digit);
}

inline constexpr double no_limit = std::numeric_limits<double>::max();
/// Of coordinates and times: the graphics card works in float.
inline constexpr double largest_float = std::numeric_limits<float>::max();
inline constexpr std::uint64_t most_whole = std::uint64_t{1} << 53; ///< exact in every JSON reader

/// What a text is. A token is a string or a number, as its JSON text; an object is its JSON text.
enum class Text : std::uint8_t { Any, Line, Lines, Colour, Object, Token, WholeToken };

/// Limits a value beyond its type. Numbers are finite without any.
struct Rule {
    double lo = -no_limit;   ///< of a number; above 0: a text must not be empty
    double hi = no_limit;    ///< of a number or a coordinate; bytes of a text, entries of a list
    bool above_zero = false; ///< 0 is refused too
    Text text = Text::Any;
    std::array<std::string_view, 3> choices{}; ///< texts; none: all
    const char* if_missing = "";               ///< what is said then, beside that it is
    bool needed = false;                       ///< set by the reader
};

/// Keeps the first fault, with the member's name. A member that is missing or null stays as it is.
class JsonReader {
  public:
    static constexpr bool reads = true;

    /// `object` must outlive this. In a call, a member that the list lacks is a fault.
    explicit JsonReader(const nlohmann::json& object, bool call = false);

    /// An object that lacks it is refused.
    template <class Value>
    void needed(const char* name, Value& to, Rule rule = {}) {
        rule.needed = true;
        newer(name, to, rule);
    }

    template <class Value>
    void newer(const char* name, Value& to, const Rule& rule = {}) {
        if (const auto* from = find(
                name, rule, requires { to.given; }))
            check(name, read_value(*from, to, rule, *this));
    }

    template <class Value>
    void some(const char* name,
              Value& to,
              const Rule& rule = {},
              const std::type_identity_t<Value>& = {}) {
        newer(name, to, rule);
    }

    template <class Value>
    void told(const char*, const Value&) {}

    template <class Value>
    void some_told(const char*, const Value&) {}

    /// Says what is wrong with a member; nothing, where `wrong` is empty.
    void check(std::string_view name, std::string_view wrong);

    /// Error: the first fault: in a call InvalidArgument, and of what is kept Corrupt.
    core::Result<void> verdict();

    /// Reads an object inside this one. Returns what is wrong, or an empty text.
    template <class Struct>
    std::string inside(const nlohmann::json& object, Struct& to) {
        JsonReader in(object, call_);
        members(in, to);
        return wrong_inside(in);
    }

  private:
    std::string wrong_inside(JsonReader& in);
    const nlohmann::json* find(const char* name, const Rule& rule, bool nullable);

    const nlohmann::json& object_;
    bool call_;
    std::vector<std::string> known_;
    std::string fault_;
    std::string hint_; ///< of an unknown name; the words of all others say what is wanted
};

/// Adds members to an object.
class JsonWriter {
  public:
    static constexpr bool reads = false;

    /// `to` must outlive this. @param kept  what is only told is left out
    explicit JsonWriter(nlohmann::json& to, bool kept = false);

    template <class Value>
    void needed(const char* name, const Value& value, const Rule& rule = {}) {
        write_value(member(name), value, rule);
    }

    /// Is always written; older files lack it.
    template <class Value>
    void newer(const char* name, const Value& value, const Rule& rule = {}) {
        needed(name, value, rule);
    }

    /// Is left out where it is empty or as it is at first.
    template <class Value>
    void
    some(const char* name, const Value& value, const Rule& rule = {}, const Value& initial = {}) {
        if constexpr (requires { value.has_value(); }) {
            if (value)
                needed(name, *value, rule);
        } else if (!(value == initial)) {
            needed(name, value, rule);
        }
    }

    /// Is told, but neither taken nor kept.
    template <class Value>
    void told(const char* name, const Value& value) {
        if (!kept_)
            needed(name, value);
    }

    template <class Value>
    void some_told(const char* name, const Value& value) {
        if (!kept_)
            some(name, value);
    }

    void check(std::string_view, std::string_view) {}

  private:
    nlohmann::json& member(const char* name);

    nlohmann::json& to_;
    bool kept_;
};

/// The struct as a list of members takes it.
template <class Io, class Struct>
using Of = std::conditional_t<Io::reads, Struct, const Struct>;

// The values of members. What is read returns what is wrong, or an empty text.
std::string read_value(const nlohmann::json& from, nlohmann::json& to, const Rule&, JsonReader&);
std::string read_value(const nlohmann::json& from, bool& to, const Rule&, JsonReader&);
std::string read_value(const nlohmann::json& from, double& to, const Rule& rule, JsonReader&);
std::string
read_value(const nlohmann::json& from, std::uint64_t& to, const Rule& rule, JsonReader&);
std::string read_value(const nlohmann::json& from, std::int64_t& to, const Rule& rule, JsonReader&);
std::string read_value(const nlohmann::json& from, std::string& to, const Rule& rule, JsonReader&);
std::string read_value(const nlohmann::json& from, core::Vec3& to, const Rule& rule, JsonReader&);
std::string read_value(const nlohmann::json& from, core::Box& to, const Rule&, JsonReader&);
/// [null,null] is the range that is not known: NaN, which JSON lacks.
std::string
read_value(const nlohmann::json& from, std::array<double, 2>& to, const Rule&, JsonReader& in);
std::string read_value(const nlohmann::json& from,
                       std::vector<core::Vec3>& to,
                       const Rule& rule,
                       JsonReader& in);
std::string read_value(const nlohmann::json& from,
                       std::vector<std::string>& to,
                       const Rule& rule,
                       JsonReader& in);
void write_value(nlohmann::json& to, const nlohmann::json& value, const Rule&);
void write_value(nlohmann::json& to, const std::string& value, const Rule& rule);
void write_value(nlohmann::json& to, const core::Vec3& value, const Rule&);
void write_value(nlohmann::json& to, const core::Box& value, const Rule&);

/// "must be a, b or c"
std::string must_be(std::span<const std::string_view> words);

template <class Json, std::integral Whole>
std::string read_value(const Json& from, Whole& to, Rule rule, JsonReader& in) {
    rule.lo = std::max<double>(rule.lo, std::numeric_limits<Whole>::min());
    rule.hi = std::min<double>(rule.hi, std::numeric_limits<Whole>::max());
    std::conditional_t<std::is_signed_v<Whole>, std::int64_t, std::uint64_t> wide{};
    const Rule& narrow = rule;
    std::string wrong = read_value(from, wide, narrow, in);
    to = static_cast<Whole>(wide);
    return wrong;
}

template <class Json, class Enum>

requires std::is_enum_v<Enum> std::string
read_value(const Json& from, Enum& to, const Rule&, JsonReader& in) {
    std::string text;
    std::string wrong = read_value(from, text, Rule{.hi = 256, .text = Text::Line}, in);
    const auto value = value_of<Enum>(text);
    to = value.value_or(to);
    std::array<std::string_view, words_of<Enum>.size()> words;
    std::ranges::transform(words_of<Enum>, words.begin(), &Word<Enum>::second);
    return value || !wrong.empty() ? wrong : must_be(words);
}

template <class Json, class List>
std::string read_list(const Json& from, List& to, JsonReader& in) {
    if (!from.is_array())
        return "must be a list";
    if constexpr (requires { to.resize(0); })
        to.resize(from.size());
    if (from.size() != to.size())
        return "must have " + std::to_string(to.size()) + " entries";
    std::string wrong;
    for (std::size_t i = 0; i < to.size() && wrong.empty(); ++i)
        wrong = read_value(from[i], to[i], Rule{}, in);
    return wrong;
}

template <class Json, class Value>
std::string read_value(const Json& from, std::vector<Value>& to, const Rule&, JsonReader& in) {
    return read_list(from, to, in);
}

template <class Json, class Value, std::size_t count>
std::string
read_value(const Json& from, std::array<Value, count>& to, const Rule&, JsonReader& in) {
    return read_list(from, to, in);
}

template <class Json, class Value>
std::string
read_value(const Json& from, std::map<std::string, Value>& to, const Rule&, JsonReader& in) {
    if (!from.is_object())
        return "must be an object";
    std::string wrong;
    for (const auto& [name, each] : from.items())
        if (wrong.empty())
            wrong = read_value(each, to[name], Rule{}, in);
    return wrong;
}

template <class Json, class Value>
std::string
read_value(const Json& from, std::optional<Value>& to, const Rule& rule, JsonReader& in) {
    return read_value(from, to.emplace(), rule, in);
}

template <class Json, class Value>
std::string read_value(const Json& from, Nullable<Value>& to, const Rule& rule, JsonReader& in) {
    to.given = true;
    return from.is_null() ? std::string() : read_value(from, to.value, rule, in);
}

template <class Json, class Struct>

requires std::is_class_v<Struct> std::string
read_value(const Json& from, Struct& to, const Rule&, JsonReader& in) {
    return in.inside(from, to);
}

template <class Json, class Value>
void write_value(Json& to, const Value& value, const Rule& rule) {
    if constexpr (std::is_arithmetic_v<Value>) {
        to = value;
    } else if constexpr (std::is_enum_v<Value>) {
        to = name(value);
    } else if constexpr (requires { value.has_value(); }) {
        if (value)
            write_value(to, *value, rule);
    } else if constexpr (requires { typename Value::mapped_type; }) {
        to = Json::object();
        for (const auto& [name, each] : value)
            write_value(to[name], each, Rule{});
    } else if constexpr (requires { value.size(); }) {
        to = Json::array();
        for (const auto& each : value)
            write_value(to.emplace_back(), each, Rule{});
    } else {
        JsonWriter out(to);
        members(out, value);
    }
}

/// Reads the parameters of a call. Error: InvalidArgument, with the first fault, or else an unknown name.
template <class Struct>
core::Result<Struct> parse_call(const nlohmann::json& from) {
    JsonReader in(from, true);
    Struct out;
    members(in, out);
    return in.verdict().map([&] { return std::move(out); });
}

/// Reads what is kept; members that the list lacks are left to newer versions. Error: Corrupt.
template <class Struct>
core::Result<Struct> parse_kept(const nlohmann::json& from) {
    JsonReader in(from);
    Struct out;
    members(in, out);
    return in.verdict().map([&] { return std::move(out); });
}

/// Returns a value as answers have it.
template <class Value, class Json = nlohmann::json>
Json written(const Value& value) {
    Json out;
    write_value(out, value, Rule{});
    return out;
}

/// Returns a struct as it is kept.
template <class Struct, class Json = nlohmann::json>
Json kept(const Struct& value) {
    Json out;
    JsonWriter to(out, true);
    members(to, value);
    return out;
}

} // namespace wakesurf::protocol
