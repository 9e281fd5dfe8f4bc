#include "core/field/function_flow.hpp"

#include "core/field/bounded_form.hpp"

#include <utility>

namespace wakesurf::core {

namespace {

struct FunctionForm {
    VelocityFunction function;

    Vec3 velocity(const Vec3& p, double t) const { return function(p, t); }
};

struct FunctionRoundBody : FunctionForm {
    FlowBody body;

    bool solid(const Vec3& p) const { return body.solid(p); }

    WallGeometry wall(const Box&) const { return body.wall; }
};

} // namespace

std::unique_ptr<Flow> make_function_flow(VelocityFunction velocity, const Box& domain) {
    return std::make_unique<AnalyticFlow<FunctionForm>>(FunctionForm{std::move(velocity)}, domain);
}

std::unique_ptr<Flow>
make_function_flow(VelocityFunction velocity, const Box& domain, FlowBody body) {
    return std::make_unique<AnalyticFlow<FunctionRoundBody>>(
        FunctionRoundBody{{std::move(velocity)}, std::move(body)}, domain, true);
}

} // namespace wakesurf::core
