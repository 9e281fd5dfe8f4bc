#include "protocol/api/base/json_members.hpp"

#include <nlohmann/json.hpp>

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
    return get<std::string>(name);
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
