// Annotations in messages: a note of somebody's at a point in space.
// Twin: web-client/src/protocol/messages.ts.
#pragma once

#include "core/base/vec3.hpp"
#include "protocol/api/checked_json.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::protocol {

struct AnnotationLimits {
    std::size_t text_bytes = std::size_t{4} << 10;
    std::size_t name_bytes = 120;
};

struct AnnotationSetting {
    std::optional<std::string> annotation; ///< nothing: create one
    std::string text;                      ///< of one line or several
    core::Vec3 position{0.0};
    std::optional<std::string> surface; ///< the surface it speaks of
    std::optional<std::uint64_t> if_rev;
};

/// Reads the parameters of annotation.set; faults stay in `in`.
AnnotationSetting read_annotation_setting(CheckedJson& in, const AnnotationLimits& limits);

struct AnnotationRecord {
    std::string annotation;
    std::uint64_t rev = 0;
    std::string text;
    core::Vec3 position{0.0};
    std::string author;                 ///< name of who made it
    std::optional<std::string> surface; ///< which may be gone since

    bool operator==(const AnnotationRecord&) const = default;
};

nlohmann::json annotation_json(const AnnotationRecord& record);

/// What annotation_json gave; faults stay in `in`.
AnnotationRecord read_annotation_record(CheckedJson& in, const AnnotationLimits& limits);

} // namespace wakesurf::protocol
