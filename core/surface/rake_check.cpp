#include "core/surface/rake_check.hpp"

#include <algorithm>
#include <string>

namespace wakesurf::core {

namespace {

/// Why a rake cannot be one, or an empty string.
std::string fault(const Rake& rake) {
    if (!std::all_of(rake.points.begin(), rake.points.end(), finite))
        return "a rake point is not finite";
    if (rake.seeds < 2)
        return "a rake needs at least 2 seeds";
    const std::size_t wanted = rake.kind == Rake::Kind::Circle ? 3 : 2;
    if (rake.points.size() < wanted || (rake.kind == Rake::Kind::Line && rake.points.size() != 2) ||
        (rake.kind == Rake::Kind::Circle && rake.points.size() != 3))
        return rake.kind == Rake::Kind::Line ? "a line rake needs exactly 2 points"
               : rake.kind == Rake::Kind::Circle
                   ? "a circle rake needs a centre and 2 points of its rim"
                   : "a rake needs at least 2 points";
    for (std::size_t i = 1; i < rake.points.size(); ++i)
        if (glm::length(rake.points[i] - rake.points[i - 1]) ==
            0.0) // 1e-320 apart is no length either
            return "two neighbouring rake points coincide";
    if (rake.kind == Rake::Kind::Circle) {
        const Vec3 u = rake.points[1] - rake.points[0];
        const Vec3 w = rake.points[2] - rake.points[0];
        if (glm::length(glm::cross(u, w)) <= 1e-9 * glm::length(u) * glm::length(w))
            return "a circle rake's centre and rim points lie on one line";
    }
    return {};
}

} // namespace

Result<void> check_rake(const Rake& rake) {
    if (const std::string reason = fault(rake); !reason.empty())
        return fail(Error::Code::InvalidArgument, reason, "correct the rake's points or seeds");
    return {};
}

} // namespace wakesurf::core
