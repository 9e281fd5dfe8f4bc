#include "protocol/api/base/checked_json.hpp"

#include "protocol/api/base/json_text.hpp"
#include "protocol/api/base/nearest_name.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

std::string range_text(double lo, double hi) {
    constexpr double huge = std::numeric_limits<double>::max();
    if (lo <= -huge && hi >= huge)
        return "must be a finite number";
    if (hi >= huge)
        return fmt::format("must be a finite number from {}", lo);
    return fmt::format("must be a number between {} and {}", lo, hi);
}

/// Returns nothing for other types, fractions, and what 64 bits do not hold. 3.0 is a whole number, as in
/// JSON Schema.
std::optional<std::uint64_t> whole(const json& value) {
    if (value.is_number_unsigned())
        return value.get<std::uint64_t>();
    if (!value.is_number_float())
        return std::nullopt;
    const auto number = value.get<double>();
    constexpr double largest_exact = 9007199254740992.0;
    if (!(number >= 0.0 && number <= largest_exact) || number != std::floor(number))
        return std::nullopt;
    return static_cast<std::uint64_t>(number);
}

/// Coordinates must stay finite as float, which the graphics card works in.
bool coordinate(const json& value) {
    return value.is_number() && std::isfinite(static_cast<float>(value.get<double>()));
}

bool is_point(const json& value) {
    return value.is_array() && value.size() == 3 &&
           std::all_of(value.begin(), value.end(), coordinate);
}

core::Vec3 point_of(const json& value) {
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

} // namespace

CheckedJson::CheckedJson(const json& object) : object_(object) {
    if (!object.is_object())
        fault_ = "`params` must be an object: parameters have names";
}

const json* CheckedJson::find(std::string_view name) {
    if (std::find(known_.begin(), known_.end(), name) == known_.end())
        known_.emplace_back(name);
    if (!object_.is_object())
        return nullptr;
    const auto found = object_.find(name);
    return found == object_.end() || found->is_null() ? nullptr : &*found;
}

const json* CheckedJson::need(std::string_view name) {
    const json* value = find(name);
    if (value == nullptr)
        fault(name, "is missing");
    return value;
}

bool CheckedJson::has(std::string_view name) {
    return find(name) != nullptr;
}

bool CheckedJson::given(std::string_view name) {
    if (std::find(known_.begin(), known_.end(), name) == known_.end())
        known_.emplace_back(name);
    return object_.is_object() && object_.contains(name);
}

std::string CheckedJson::text(std::string_view name, std::size_t longest) {
    return need(name) == nullptr ? std::string{} : text_or(name, {}, longest);
}

std::optional<std::string> CheckedJson::text_if(std::string_view name, std::size_t longest) {
    return find(name) == nullptr ? std::nullopt : std::optional(text_or(name, {}, longest));
}

std::string CheckedJson::some_text(std::string_view name, std::size_t longest) {
    std::string out = text(name, longest);
    if (out.empty())
        fault(name, "must not be empty");
    return out;
}

std::optional<std::string> CheckedJson::some_text_if(std::string_view name, std::size_t longest) {
    auto out = text_if(name, longest);
    if (out && out->empty())
        fault(name, "must not be empty: leave it out");
    return out;
}

std::string CheckedJson::text_or(std::string_view name, std::string fallback, std::size_t longest) {
    const json* value = find(name);
    if (value == nullptr)
        return fallback;
    if (!value->is_string()) {
        fault(name, "must be a string");
        return fallback;
    }
    const auto& text = value->get_ref<const std::string&>();
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (text.size() > longest || std::any_of(text.begin(), text.end(), control)) {
        fault(name, fmt::format("must be at most {} bytes without control characters", longest));
        return fallback;
    }
    return text;
}

std::string CheckedJson::lines(std::string_view name, std::size_t longest) {
    const json* value = need(name);
    if (value == nullptr)
        return {};
    const auto control = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
    };
    if (value->is_string())
        if (const auto& text = value->get_ref<const std::string&>();
            text.size() <= longest && std::none_of(text.begin(), text.end(), control))
            return text;
    fault(name, fmt::format("must be text of at most {} bytes; of control characters it may only "
                            "have line breaks and tabs",
                            longest));
    return {};
}

std::string CheckedJson::object_text(std::string_view name, std::size_t longest) {
    const json* value = need(name);
    if (value == nullptr)
        return "{}";
    if (value->is_object())
        if (std::string text = json_text(*value); text.size() <= longest)
            return text;
    fault(name, fmt::format("must be an object of at most {} bytes of JSON text", longest));
    return "{}";
}

bool CheckedJson::flag_or(std::string_view name, bool fallback) {
    const json* value = find(name);
    if (value == nullptr)
        return fallback;
    if (value->is_boolean())
        return value->get<bool>();
    fault(name, "must be true or false");
    return fallback;
}

double CheckedJson::number(std::string_view name, double lo, double hi) {
    return need(name) == nullptr ? lo : number_or(name, lo, hi, lo);
}

double CheckedJson::number_or(std::string_view name, double lo, double hi, double fallback) {
    return number_if(name, lo, hi).value_or(fallback);
}

std::optional<double> CheckedJson::number_if(std::string_view name, double lo, double hi) {
    const json* value = find(name);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_number())
        if (const auto number = value->get<double>();
            std::isfinite(number) && number >= lo && number <= hi)
            return number;
    fault(name, range_text(lo, hi));
    return std::nullopt;
}

std::uint64_t CheckedJson::count(std::string_view name, std::uint64_t lo, std::uint64_t hi) {
    return need(name) == nullptr ? lo : count_or(name, lo, hi, lo);
}

std::uint64_t CheckedJson::count_or(std::string_view name,
                                    std::uint64_t lo,
                                    std::uint64_t hi,
                                    std::uint64_t fallback) {
    return count_if(name, lo, hi).value_or(fallback);
}

std::optional<std::uint64_t>
CheckedJson::count_if(std::string_view name, std::uint64_t lo, std::uint64_t hi) {
    const json* value = find(name);
    if (value == nullptr)
        return std::nullopt;
    if (const auto number = whole(*value); number && *number >= lo && *number <= hi)
        return number;
    fault(name, fmt::format("must be a whole number between {} and {}", lo, hi));
    return std::nullopt;
}

core::Vec3 CheckedJson::point(std::string_view name) {
    return need(name) == nullptr ? core::Vec3(0.0) : point_if(name).value_or(core::Vec3(0.0));
}

std::optional<core::Vec3> CheckedJson::point_if(std::string_view name) {
    const json* value = find(name);
    if (value == nullptr)
        return std::nullopt;
    if (is_point(*value))
        return point_of(*value);
    fault(name, "must be three finite numbers [x,y,z]");
    return std::nullopt;
}

std::vector<core::Vec3> CheckedJson::points(std::string_view name, std::size_t most) {
    std::vector<core::Vec3> out;
    const json* value = need(name);
    if (value == nullptr)
        return out;
    if (!value->is_array() || value->size() > most) {
        fault(name, fmt::format("must be a list of at most {} points [x,y,z]", most));
        return out;
    }
    for (const json& point : *value) {
        if (!is_point(point)) {
            fault(name, fmt::format("must hold points of three finite numbers; point {} is not one",
                                    out.size()));
            return {};
        }
        out.push_back(point_of(point));
    }
    return out;
}

std::vector<std::string> CheckedJson::texts_or_none(std::string_view name, std::size_t most) {
    std::vector<std::string> out;
    const json* value = find(name);
    if (value == nullptr)
        return out;
    const auto is_text = [](const json& entry) { return entry.is_string(); };
    if (!value->is_array() || value->size() > most ||
        !std::all_of(value->begin(), value->end(), is_text)) {
        fault(name, fmt::format("must be a list of at most {} names", most));
        return out;
    }
    for (const json& entry : *value)
        out.push_back(entry.get<std::string>());
    return out;
}

std::string CheckedJson::token(std::string_view name, bool whole) {
    return need(name) == nullptr ? std::string{} : token_if(name, whole).value_or("");
}

std::optional<std::string> CheckedJson::token_if(std::string_view name, bool whole) {
    const json* value = find(name);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_string() || (whole ? value->is_number_integer() : value->is_number()))
        return json_text(*value);
    fault(name, whole ? "must be a string or a whole number" : "must be a string or a number");
    return std::nullopt;
}

void CheckedJson::inside(std::string_view name, const std::function<void(CheckedJson&)>& read) {
    const json* value = need(name);
    if (value == nullptr)
        return;
    CheckedJson inner(*value);
    read(inner);
    if (const auto sound = inner.verdict(); !sound && fault_.empty()) {
        fault(name, "is invalid: " + sound.error().message);
        hint_ = sound.error().hint;
    }
}

void CheckedJson::fault(std::string_view name, std::string_view problem) {
    if (fault_.empty())
        fault_ = fmt::format("`{}` {}", name, problem);
}

core::Result<void> CheckedJson::verdict() {
    if (fault_.empty() && object_.is_object())
        for (const auto& [name, value] : object_.items())
            if (std::find(known_.begin(), known_.end(), name) == known_.end()) {
                fault(name.substr(0, 64), "is not a parameter of this method");
                const std::string meant = nearest_name(name, known_);
                hint_ = meant.empty() ? there_is(known_) : "did you mean `" + meant + "`?";
                break;
            }
    if (!fault_.empty())
        return core::fail(core::Error::Code::InvalidArgument, fault_, hint_);
    return {};
}

core::Result<void> CheckedJson::record_verdict() const {
    if (!fault_.empty())
        return core::fail(core::Error::Code::Corrupt, fault_);
    return {};
}

} // namespace wakesurf::protocol
