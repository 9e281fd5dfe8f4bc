// Lists of values, and points, as JSON arrays.
#pragma once

#include "core/base/vec3.hpp"

#include <nlohmann/json_fwd.hpp>

#include <iterator>
#include <type_traits>
#include <vector>

namespace wakesurf::protocol {

/// [x, y, z]
nlohmann::json point_json(const core::Vec3& point);

/// [[x, y, z], ...]
nlohmann::json points_json(const std::vector<core::Vec3>& points);

/// Returns the array of what `write` makes of each value. Its callers include the JSON library, which is no
/// header's matter.
template <class Values, class Write>
auto list_json(const Values& values, Write write) {
    using Json = std::invoke_result_t<Write, decltype(*std::begin(values))>;
    Json list = Json::array();
    for (const auto& each : values)
        list.push_back(write(each));
    return list;
}

} // namespace wakesurf::protocol
