#include "protocol/api/family_json.hpp"

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/family.hpp"
#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

core::FamilyStep parse_step(const json& value, JsonMembers& family) {
    JsonMembers members(value);
    core::FamilyStep step;
    core::FamilyCounts& n = step.counts;
    step.index = members.count("index");
    step.time = members.number("time");
    n.nodes = members.count("nodes");
    n.reached = members.count("reached");
    n.at_rest = members.count("atRest");
    n.obstacle = members.count("obstacle");
    n.lost = members.count("lost");
    n.outside = members.count("outside");
    n.range = members.numbers_of<2>("range");
    if (!members.verdict())
        family.fault("steps", members.verdict().error().message);
    return step;
}

core::Vec3 parse_point(JsonMembers& members, const char* name) {
    const auto xyz = members.numbers_of<3>(name);
    return {xyz[0], xyz[1], xyz[2]};
}

core::Rake parse_curve(JsonMembers& members) {
    core::Rake rake;
    const auto kind = rake_kind(members.text("rakeKind"));
    if (!kind)
        members.fault("rakeKind", "is not a kind of rake this version knows");
    rake.kind = kind.value_or(core::Rake::Kind::Line);
    for (const json& each : members.list("points")) {
        const bool three = each.is_array() && each.size() == 3 && each[0].is_number() &&
                           each[1].is_number() && each[2].is_number();
        if (!three)
            members.fault("points", "must hold points");
        else
            rake.points.emplace_back(each[0].get<double>(), each[1].get<double>(),
                                     each[2].get<double>());
    }
    return rake;
}

} // namespace

json family_json(const core::FamilyRecord& family) {
    const core::FamilyRequest& request = family.request;
    json out{{"name", family.name},
             {"accuracy", name(request.accuracy)},
             {"length", request.length},
             {"version", family.version},
             {"steps", list_json(family.steps, family_step_json)}};
    if (const auto* rake = std::get_if<core::Rake>(&request.source)) {
        out["from"] = "curve";
        out["rakeKind"] = name(rake->kind);
        out["points"] = points_json(rake->points);
        return out;
    }
    out["scalar"] = request.scalar;
    out["from"] = "inflow";
    if (const auto* plane = std::get_if<core::FamilyPlane>(&request.source)) {
        out["from"] = "plane";
        out["point"] = point_json(plane->point);
        out["normal"] = point_json(plane->normal);
    }
    return out;
}

core::Result<core::FamilyRecord> parse_family(const json& value) {
    JsonMembers members(value);
    core::FamilyRecord family;
    family.name = members.text("name");
    family.version = members.text("version");
    core::FamilyRequest& request = family.request;
    request.length = members.number("length");
    const auto accuracy = protocol::accuracy(members.text("accuracy"));
    if (!accuracy)
        members.fault("accuracy", "is not one this version knows");
    request.accuracy = accuracy.value_or(core::Accuracy::Balanced);
    const std::string from = members.text("from");
    if (from == "curve")
        request.source = parse_curve(members);
    else if (from == "plane")
        request.source =
            core::FamilyPlane{parse_point(members, "point"), parse_point(members, "normal")};
    else if (from != "inflow")
        members.fault("from", "is not a source this version knows");
    if (from != "curve")
        request.scalar = members.text("scalar");
    for (const json& each : members.list("steps"))
        family.steps.push_back(parse_step(each, members));
    if (family.steps.empty())
        members.fault("steps", "must not be empty");
    return members.verdict().map([&] { return std::move(family); });
}

} // namespace wakesurf::protocol
