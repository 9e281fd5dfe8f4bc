#include "protocol/api/base/json_members.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

const json empty_list = json::array();
const json empty_object = json::object();

} // namespace

JsonMembers::JsonMembers(const json& object) : object_(object) {
    if (!object.is_object())
        fault_ = "it must be an object";
}

const json* JsonMembers::find(std::string_view name) {
    if (object_.is_object())
        if (const auto found = object_.find(name); found != object_.end())
            return &*found;
    fault(name, "is missing");
    return nullptr;
}

bool JsonMembers::has(std::string_view name) const {
    return object_.is_object() && object_.contains(name) && !object_.find(name)->is_null();
}

std::string JsonMembers::text(std::string_view name) {
    const json* value = find(name);
    if (value != nullptr && value->is_string())
        return value->get<std::string>();
    fault(name, "must be a string");
    return {};
}

bool JsonMembers::flag(std::string_view name) {
    const json* value = find(name);
    if (value != nullptr && value->is_boolean())
        return value->get<bool>();
    fault(name, "must be true or false");
    return false;
}

double JsonMembers::number(std::string_view name) {
    const json* value = find(name);
    if (value != nullptr && value->is_number() && std::isfinite(value->get<double>()))
        return value->get<double>();
    fault(name, "must be a finite number");
    return 0.0;
}

std::uint64_t JsonMembers::count(std::string_view name, std::uint64_t most) {
    const json* value = find(name);
    // Text holds unsigned numbers, C++ code signed ones.
    const bool whole = value != nullptr && value->is_number_integer() &&
                       (value->is_number_unsigned() || value->get<std::int64_t>() >= 0);
    if (whole && value->get<std::uint64_t>() <= most)
        return value->get<std::uint64_t>();
    fault(name, "must be a whole number between 0 and " + std::to_string(most));
    return 0;
}

std::int64_t JsonMembers::integer(std::string_view name) {
    const json* value = find(name);
    // An unsigned value beyond int64 would wrap.
    if (value != nullptr && value->is_number_integer() &&
        (!value->is_number_unsigned() ||
         value->get<std::uint64_t>() <= std::numeric_limits<std::int64_t>::max()))
        return value->get<std::int64_t>();
    fault(name, "must be a whole number");
    return 0;
}

std::vector<double> JsonMembers::numbers(std::string_view name) {
    std::vector<double> out;
    for (const json& value : list(name)) {
        if (!value.is_number() || !std::isfinite(value.get<double>())) {
            fault(name, "must hold finite numbers only");
            return {};
        }
        out.push_back(value.get<double>());
    }
    return out;
}

const json& JsonMembers::list(std::string_view name) {
    const json* value = find(name);
    if (value != nullptr && value->is_array())
        return *value;
    fault(name, "must be a list");
    return empty_list;
}

const json& JsonMembers::object(std::string_view name) {
    const json* value = find(name);
    if (value != nullptr && value->is_object())
        return *value;
    fault(name, "must be an object");
    return empty_object;
}

void JsonMembers::fault(std::string_view name, std::string_view problem) {
    if (fault_.empty())
        fault_.append("`").append(name).append("` ").append(problem);
}

core::Result<void> JsonMembers::verdict() const {
    if (!fault_.empty())
        return core::fail(core::Error::Code::Corrupt, fault_);
    return {};
}

} // namespace wakesurf::protocol
