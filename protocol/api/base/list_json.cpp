#include "protocol/api/base/list_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

nlohmann::json point_json(const core::Vec3& point) {
    return {point.x, point.y, point.z};
}

nlohmann::json points_json(const std::vector<core::Vec3>& points) {
    return list_json(points, point_json);
}

} // namespace wakesurf::protocol
