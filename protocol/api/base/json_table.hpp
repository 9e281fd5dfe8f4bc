// Converts between a struct and a JSON object by one table of the struct's members: the same lines write and
// read what is kept. The JSON type is a parameter, so that only source files include the JSON library.
#pragma once

#include "core/base/box.hpp"
#include "core/base/result.hpp"
#include "protocol/api/base/list_json.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace wakesurf::protocol {

/// Describes a member of a struct. `always`: it is written even where it has its default.
template <class Struct, class Value, bool always>
struct TableMember {
    const char* name; ///< null: the members of the value stand in the same object
    Value Struct::*place;
    bool needed; ///< an object that lacks it is refused
};

/// Is always written, and an object that lacks it is refused.
template <class Struct, class Value>
constexpr TableMember<Struct, Value, true> needed(const char* name, Value Struct::*place) {
    return {name, place, true};
}

/// Puts the members of `place` into the same object.
template <class Struct, class Value>
constexpr TableMember<Struct, Value, true> those_of(Value Struct::*place) {
    return {nullptr, place, true};
}

/// Is always written, but may be missing: older files lack it.
template <class Struct, class Value>
constexpr TableMember<Struct, Value, true> newer(const char* name, Value Struct::*place) {
    return {name, place, false};
}

/// Is left out where it has its default.
template <class Struct, class Value>
constexpr TableMember<Struct, Value, false> some(const char* name, Value Struct::*place) {
    return {name, place, false};
}

/// Is specialised for each struct that is kept: a tuple of its members.
template <class Struct>
inline constexpr std::tuple<> table_of;

template <class Enum>
using Word = std::pair<Enum, std::string_view>;

/// Is specialised for each enumeration that is a member: the words for its values.
template <class Enum>
inline constexpr std::array<Word<Enum>, 0> words_of;

template <class Enum>
std::string_view word_of(Enum value) {
    for (const auto& [each, word] : words_of<Enum>)
        if (each == value)
            return word;
    return {};
}

template <class Value>
concept HasTable = (std::tuple_size_v<decltype(table_of<Value>)> > 0);

template <class Value>
inline constexpr bool is_list = false;
template <class Each>
inline constexpr bool is_list<std::vector<Each>> = true;
template <class Each, std::size_t count>
inline constexpr bool is_list<std::array<Each, count>> = true;

/// Returns a struct, or the value of a member, as JSON.
template <class Json, class Value>
Json written(const Value& value) {
    if constexpr (HasTable<Value>) {
        Json out = Json::object();
        const auto write =
            [&]<class Each, bool always>(const TableMember<Value, Each, always>& member) {
                const Each& inner = value.*member.place;
                if constexpr (!always)
                    if (inner == Value{}.*member.place)
                        return;
                if (member.name == nullptr)
                    out.update(written<Json>(inner));
                else
                    out[member.name] = written<Json>(inner);
            };
        std::apply([&](const auto&... each) { (write(each), ...); }, table_of<Value>);
        return out;
    } else if constexpr (std::is_enum_v<Value>) {
        return word_of(value);
    } else if constexpr (std::is_same_v<Value, core::Vec3>) {
        return {value.x, value.y, value.z};
    } else if constexpr (std::is_same_v<Value, core::Box>) {
        const auto& [lo, hi] = value;
        return {lo.x, hi.x, lo.y, hi.y, lo.z, hi.z};
    } else if constexpr (is_list<Value>) {
        return list_json(value, [](const auto& each) { return written<Json>(each); });
    } else if constexpr (requires { value.value(); }) {
        return written<Json>(*value);
    } else {
        return value;
    }
}

/// Reads it back; members that the table lacks are ignored. Returns what is wrong, or an empty text.
template <class Json, class Value>
std::string read_back(const Json& from, Value& to) {
    std::string wrong;
    if constexpr (HasTable<Value>) {
        if (!from.is_object())
            return "must be an object";
        const auto read = [&](const auto& member) {
            if (!wrong.empty())
                return;
            if (member.name == nullptr) {
                wrong = read_back(from, to.*member.place);
                return;
            }
            const auto found = from.find(member.name);
            if (found != from.end() && !found->is_null())
                wrong = read_back(*found, to.*member.place);
            else if (member.needed)
                wrong = "is missing";
            if (!wrong.empty())
                wrong = '`' + std::string(member.name) + "` " + wrong;
        };
        std::apply([&](const auto&... each) { (read(each), ...); }, table_of<Value>);
        return wrong;
    } else if constexpr (std::is_enum_v<Value>) {
        for (const auto& [each, word] : words_of<Value>)
            if (from == word) {
                to = each;
                return {};
            }
        return "is unknown to this version";
    } else if constexpr (std::is_same_v<Value, core::Vec3>) {
        std::array<double, 3> axes{};
        wrong = read_back(from, axes);
        to = {axes[0], axes[1], axes[2]};
        return wrong;
    } else if constexpr (std::is_same_v<Value, core::Box>) {
        std::array<double, 6> ends{};
        wrong = read_back(from, ends);
        to = {{ends[0], ends[2], ends[4]}, {ends[1], ends[3], ends[5]}};
        return wrong;
    } else if constexpr (is_list<Value>) {
        if (!from.is_array())
            return "must be a list";
        if constexpr (std::is_same_v<Value, std::array<double, 2>>)
            if (from ==
                Json{nullptr, nullptr}) { // JSON has no NaN, which says that the range is unknown
                to.fill(std::numeric_limits<double>::quiet_NaN());
                return {};
            }
        if constexpr (requires { to.resize(from.size()); })
            to.resize(from.size());
        if (from.size() != to.size())
            return "must have " + std::to_string(to.size()) + " entries";
        for (std::size_t i = 0; i < to.size() && wrong.empty(); ++i)
            wrong = read_back(from[i], to[i]);
        return wrong;
    } else if constexpr (requires { typename Value::mapped_type; }) {
        if (!from.is_object())
            return "must be an object";
        for (const auto& [name, each] : from.items())
            if (wrong.empty())
                wrong = read_back(each, to[name]);
        return wrong;
    } else if constexpr (requires {
                             to.emplace();
                             to.value();
                         }) {
        return read_back(from, to.emplace());
    } else {
        using Limits = std::numeric_limits<Value>;
        if constexpr (std::is_same_v<Value, bool>) {
            if (!from.is_boolean())
                return "must be true or false";
        } else if constexpr (std::is_floating_point_v<Value>) {
            if (!from.is_number() || !std::isfinite(from.template get<Value>()))
                return "must be a finite number";
        } else if constexpr (std::is_integral_v<Value>) {
            // Text holds unsigned numbers, C++ code signed ones.
            if (from.is_number_unsigned()
                    ? !std::in_range<Value>(from.template get<std::uint64_t>())
                    : !from.is_number_integer() ||
                          !std::in_range<Value>(from.template get<std::int64_t>()))
                return "must be a whole number between " + std::to_string(Limits::min()) + " and " +
                       std::to_string(Limits::max());
        } else if (!from.is_string()) {
            return "must be a string";
        }
        to = from.template get<Value>();
        return {};
    }
}

/// Reads a struct back. Error: Corrupt, with what is wrong.
template <class Value, class Json>
core::Result<Value> parse_table(const Json& from) {
    Value out;
    if (const std::string wrong = read_back(from, out); !wrong.empty())
        return core::fail(core::Error::Code::Corrupt, wrong);
    return out;
}

} // namespace wakesurf::protocol
