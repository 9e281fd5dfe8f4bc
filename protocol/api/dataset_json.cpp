#include "protocol/api/dataset_json.hpp"

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_table.hpp"
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/generated/names.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

using core::FamilyCounts;
using core::FamilyPlane;
using core::FamilyRecord;
using core::FamilyStep;
using nlohmann::json;

template <>
inline constexpr auto table_of<FamilyCounts> = std::tuple(needed("nodes", &FamilyCounts::nodes),
                                                          needed("reached", &FamilyCounts::reached),
                                                          needed("atRest", &FamilyCounts::at_rest),
                                                          needed("obstacle",
                                                                 &FamilyCounts::obstacle),
                                                          needed("lost", &FamilyCounts::lost),
                                                          needed("outside", &FamilyCounts::outside),
                                                          needed("range", &FamilyCounts::range));

template <>
inline constexpr auto table_of<FamilyStep> = std::tuple(needed("index", &FamilyStep::index),
                                                        needed("time", &FamilyStep::time),
                                                        those_of(&FamilyStep::counts));

template <>
inline constexpr auto table_of<FamilyPlane> = std::tuple(needed("point", &FamilyPlane::point),
                                                         needed("normal", &FamilyPlane::normal));

template <>
inline constexpr auto table_of<FamilyRecord> = std::tuple(needed("name", &FamilyRecord::name),
                                                          needed("version", &FamilyRecord::version),
                                                          needed("steps", &FamilyRecord::steps));

namespace {

core::Rake parse_curve(JsonMembers& members) {
    core::Rake rake;
    const auto kind = rake_kind(members.text("rakeKind"));
    if (!kind)
        members.fault("rakeKind", "is not a kind of rake this version knows");
    rake.kind = kind.value_or(core::Rake::Kind::Line);
    rake.points = members.get<std::vector<core::Vec3>>("points");
    return rake;
}

} // namespace

json family_json(const FamilyRecord& family) {
    const core::FamilyRequest& request = family.request;
    json out = written<json>(family);
    out["accuracy"] = name(request.accuracy);
    out["length"] = request.length;
    if (const auto* rake = std::get_if<core::Rake>(&request.source)) {
        out["from"] = "curve";
        out["rakeKind"] = name(rake->kind);
        out["points"] = points_json(rake->points);
        return out;
    }
    out["scalar"] = request.scalar;
    out["from"] = "inflow";
    if (const auto* plane = std::get_if<FamilyPlane>(&request.source)) {
        out["from"] = "plane";
        out.update(written<json>(*plane));
    }
    return out;
}

core::Result<FamilyRecord> parse_family(const json& value) {
    auto family = parse_table<FamilyRecord>(value);
    if (!family)
        return family;
    JsonMembers members(value);
    core::FamilyRequest& request = family->request;
    request.length = members.get<double>("length");
    const auto accuracy = protocol::accuracy(members.text("accuracy"));
    if (!accuracy)
        members.fault("accuracy", "is not one this version knows");
    request.accuracy = accuracy.value_or(core::Accuracy::Balanced);
    const std::string from = members.text("from");
    if (from == "curve") {
        request.source = parse_curve(members);
    } else if (from == "plane") {
        if (const auto wrong = read_back(value, request.source.emplace<FamilyPlane>());
            !wrong.empty())
            return core::fail(core::Error::Code::Corrupt, wrong);
    } else if (from != "inflow") {
        members.fault("from", "is not a source this version knows");
    }
    if (from != "curve")
        request.scalar = members.text("scalar");
    if (family->steps.empty())
        members.fault("steps", "must not be empty");
    return members.verdict().map([&] { return std::move(*family); });
}

using core::DatasetInfo;
using core::FieldInfo;
using nlohmann::json;

template <>
inline constexpr auto words_of<FieldInfo::Source> = std::to_array<Word<FieldInfo::Source>>(
    {{FieldInfo::Source::Cell, "cell"}, {FieldInfo::Source::Point, "point"}});

template <>
inline constexpr auto table_of<FieldInfo> = std::tuple(needed("name", &FieldInfo::name),
                                                       needed("components", &FieldInfo::components),
                                                       needed("source", &FieldInfo::source),
                                                       needed("range", &FieldInfo::range),
                                                       some("unit", &FieldInfo::unit),
                                                       some("family", &FieldInfo::family),
                                                       some("stored", &FieldInfo::stored));

template <>
inline constexpr auto
    table_of<DatasetInfo> = std::tuple(needed("dataset", &DatasetInfo::dataset),
                                       needed("name", &DatasetInfo::name),
                                       needed("reader", &DatasetInfo::reader),
                                       needed("grid", &DatasetInfo::grid),
                                       needed("bounds", &DatasetInfo::bounds),
                                       needed("points", &DatasetInfo::points),
                                       needed("cells", &DatasetInfo::cells),
                                       needed("times", &DatasetInfo::times),
                                       needed("steady", &DatasetInfo::steady),
                                       needed("fields", &DatasetInfo::fields),
                                       needed("velocity", &DatasetInfo::velocity),
                                       needed("why", &DatasetInfo::why),
                                       needed("obstacle", &DatasetInfo::obstacle),
                                       needed("bytesPerStep", &DatasetInfo::bytes_per_step),
                                       newer("finestSpacing", &DatasetInfo::finest_spacing),
                                       some("periodic", &DatasetInfo::periodic),
                                       some("note", &DatasetInfo::note),
                                       some("lengthUnit", &DatasetInfo::length_unit),
                                       some("timeUnit", &DatasetInfo::time_unit),
                                       some("precision", &DatasetInfo::precision),
                                       some("dimensions", &DatasetInfo::dimensions),
                                       some("spacing", &DatasetInfo::spacing));

json dataset_json(const DatasetInfo& info) {
    return written<json>(info);
}

core::Result<DatasetInfo> parse_dataset_info(const json& value) {
    return parse_table<DatasetInfo>(value);
}

} // namespace wakesurf::protocol
