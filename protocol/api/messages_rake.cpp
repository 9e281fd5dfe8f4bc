#include "protocol/api/messages_rake.hpp"

#include "protocol/api/colour_text.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <utility>

namespace wakesurf::protocol {

namespace {

constexpr std::array<std::pair<core::Rake::Kind, std::string_view>, 4> kinds{
    {{core::Rake::Kind::Line, "line"},
     {core::Rake::Kind::Polyline, "polyline"},
     {core::Rake::Kind::Circle, "circle"},
     {core::Rake::Kind::Points, "points"}}};

} // namespace

std::string_view name(core::Rake::Kind kind) {
    for (const auto& [each, word] : kinds)
        if (each == kind)
            return word;
    return {};
}

namespace {

core::Rake read_shape(CheckedJson& in, const RakeLimits& limits) {
    core::Rake shape;
    const std::string kind = in.text("kind");
    bool known = false;
    for (const auto& [each, word] : kinds)
        if (word == kind) {
            shape.kind = each;
            known = true;
        }
    if (!known)
        in.fault("kind", "must be line, polyline, circle or points");
    shape.points = in.points("points", limits.points);
    shape.seeds =
        static_cast<std::uint32_t>(in.count("seeds", limits.seeds_least, limits.seeds_most));
    return shape;
}

} // namespace

namespace {

void check_colour(CheckedJson& in, std::string_view colour) {
    if (!is_colour(colour))
        in.fault("colour", "must be written #rrggbb");
}

} // namespace

RakeSetting read_rake_setting(CheckedJson& in, const RakeLimits& limits) {
    RakeSetting setting;
    if (in.has("rake"))
        setting.rake = in.text("rake");
    setting.shape = read_shape(in, limits);
    setting.name = in.text_or("name", {}, limits.name_bytes);
    if (in.has("colour")) {
        setting.colour = in.text("colour");
        check_colour(in, *setting.colour);
    }
    if (in.has("dragging"))
        setting.dragging = in.flag_or("dragging", false);
    setting.force = in.flag_or("force", false);
    setting.if_rev = in.count_if("ifRev", 0, most_rev);
    return setting;
}

RakeRecord read_rake_record(CheckedJson& in, const RakeLimits& limits) {
    RakeRecord record;
    record.rake = in.text("rake");
    record.rev = in.count("rev", 0, most_rev);
    record.shape = read_shape(in, limits);
    record.name = in.text_or("name", {}, limits.name_bytes);
    record.colour = in.text_or("colour", {});
    if (!record.colour.empty())
        check_colour(in, record.colour);
    record.author = in.text_or("author", {}, limits.name_bytes);
    record.clipped = in.flag_or("clipped", false);
    return record;
}

nlohmann::json points_json(const std::vector<core::Vec3>& points) {
    auto list = nlohmann::json::array();
    for (const core::Vec3& point : points)
        list.push_back({point.x, point.y, point.z});
    return list;
}

nlohmann::json rake_json(const RakeRecord& record) {
    nlohmann::json out{{"rake", record.rake},
                       {"rev", record.rev},
                       {"kind", name(record.shape.kind)},
                       {"points", points_json(record.shape.points)},
                       {"seeds", record.shape.seeds},
                       {"name", record.name},
                       {"colour", record.colour},
                       {"author", record.author},
                       {"clipped", record.clipped},
                       {"dragging", record.dragging}};
    if (!record.leased_by.empty())
        out["leasedBy"] = record.leased_by;
    return out;
}

} // namespace wakesurf::protocol
