// family.make, family.remove.
#include "protocol/api/dataset_json.hpp"
#include "protocol/api/generated/family.hpp"
#include "server/data/family_making.hpp"
#include "server/net/methods/kept_field_calls.hpp"
#include "server/net/methods/method.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

core::Error parameter(const std::string& name, const std::string& problem) {
    return {core::Error::Code::InvalidArgument, "`" + name + "` " + problem, ""};
}

core::Result<core::FamilyRequest> family_request(const protocol::FamilyMake& of) {
    core::FamilyRequest request;
    request.accuracy = of.accuracy;
    request.length = of.length.value_or(0.0);
    if (!of.scalar.empty())
        request.scalar = of.scalar;
    const bool plane = of.from == "plane";
    const bool curve = of.from == "curve";
    if (plane != of.point.has_value() || plane != of.normal.has_value())
        return tl::unexpected(parameter(of.point ? "normal" : "point",
                                        "is missing or not allowed: a plane needs `point` and "
                                        "`normal`, and nothing else has them"));
    if (curve != of.points.has_value() || curve != of.rake_kind.has_value())
        return tl::unexpected(parameter(of.points ? "rakeKind" : "points",
                                        "is missing or not allowed: a curve needs `points` and "
                                        "`rakeKind`, and nothing else has them"));
    if (curve && !of.scalar.empty())
        return tl::unexpected(parameter(
            "scalar", "is for inflow and plane only: that of a curve is the distance from it"));
    if (plane)
        request.source = core::FamilyPlane{*of.point, *of.normal};
    if (curve) {
        core::Rake rake;
        rake.kind = *of.rake_kind;
        rake.points = *of.points;
        request.source = std::move(rake);
    }
    return request;
}

void family_make(const Call& call, const protocol::FamilyMake& of, Reply reply) {
    auto request = family_request(of);
    if (!request)
        return reply.fault(request.error());
    FamilyWish wish{of.name, std::move(*request), {}};
    if (of.time)
        wish.times = {*of.time};
    if (!call.identity.grant.empty()) // which links cannot remove
        wish.most = families_of_links;
    make_kept_field(
        call, of.dataset,
        {"this family", "making the family " + of.name, of.name, "of the nodes traced",
         of.work_done_token},
        [wish = std::move(wish)](const LoadedDataset& dataset, const auto& stop,
                                 const core::WorkPart& work) {
            return make_family(dataset, wish, stop, work).map([](const auto& made) {
                return json(protocol::written(made));
            });
        },
        std::move(reply));
}

void family_remove(const Call& call, const protocol::FamilyRemove& of, Reply reply) {
    remove_kept_field(
        call, of.dataset,
        [name = of.name](const LoadedDataset& dataset) { return remove_family(dataset, name); },
        std::move(reply));
}

} // namespace

std::vector<Method> family_methods() {
    return {method(family_make), method(family_remove)};
}

} // namespace wakesurf::server
