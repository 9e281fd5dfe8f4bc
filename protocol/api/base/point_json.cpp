#include "protocol/api/base/point_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

nlohmann::json point_json(const core::Vec3& point) {
    return {point.x, point.y, point.z};
}

nlohmann::json points_json(const std::vector<core::Vec3>& points) {
    auto list = nlohmann::json::array();
    for (const core::Vec3& point : points)
        list.push_back(point_json(point));
    return list;
}

} // namespace wakesurf::protocol
