#include "protocol/api/messages_annotation.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

AnnotationSetting read_annotation_setting(CheckedJson& in, const AnnotationLimits& limits) {
    AnnotationSetting setting;
    if (in.has("annotation"))
        setting.annotation = in.text("annotation");
    setting.text = in.lines("text", limits.text_bytes);
    if (const auto position = in.point_if("position"))
        setting.position = *position;
    else
        in.fault("position", "is missing");
    if (in.has("surface"))
        setting.surface = in.text("surface");
    setting.if_rev = in.count_if("ifRev", 0, most_rev);
    return setting;
}

AnnotationRecord read_annotation_record(CheckedJson& in, const AnnotationLimits& limits) {
    AnnotationSetting setting = read_annotation_setting(in, limits);
    return {in.text("annotation"),
            in.count("rev", 0, most_rev),
            std::move(setting.text),
            setting.position,
            in.text_or("author", {}, limits.name_bytes),
            std::move(setting.surface)};
}

nlohmann::json annotation_json(const AnnotationRecord& record) {
    const core::Vec3& p = record.position;
    nlohmann::json out{{"annotation", record.annotation},
                       {"rev", record.rev},
                       {"text", record.text},
                       {"position", {p.x, p.y, p.z}},
                       {"author", record.author}};
    if (record.surface)
        out["surface"] = *record.surface;
    return out;
}

} // namespace wakesurf::protocol
