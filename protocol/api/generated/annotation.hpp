// Made by protocol/api/generate from annotation.schema.json: do not edit.
// Annotations: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "core/base/vec3.hpp"
#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// An annotation as the session keeps it.
struct AnnotationRecord {
    /// id of the annotation
    std::string annotation;
    /// counts the edits of a record
    std::uint64_t rev = 0;
    /// text of one or more lines
    std::string text;
    /// the point that it refers to (the dataset's unit of length)
    core::Vec3 position{0.0};
    /// name of the one who made it
    std::string author;
    /// id of the surface that it refers to, which may have been deleted since
    std::optional<std::string> surface;

    bool operator==(const AnnotationRecord&) const = default;
};

void read(CheckedJson& in, AnnotationRecord& out);

nlohmann::json record_json(const AnnotationRecord& record);

/// Returns it as it is kept: what read() reads.
nlohmann::json kept_json(const AnnotationRecord& record);

/// Holds the parameters of annotation.set.
struct AnnotationSetting : InSession {
    static constexpr std::string_view method = "annotation.set";

    /// id of the annotation to replace; if left out, a new one is created
    std::optional<std::string> annotation;
    /// text of one or more lines
    std::string text;
    /// the point that it refers to (the dataset's unit of length)
    core::Vec3 position{0.0};
    /// id of the surface that it refers to, which may have been deleted since
    std::optional<std::string> surface;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// Holds the parameters of annotation.delete.
struct AnnotationDelete : InSession {
    static constexpr std::string_view method = "annotation.delete";

    /// an id from annotation.list
    std::string annotation;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// Holds the parameters of annotation.list.
struct AnnotationList : InSession {
    static constexpr std::string_view method = "annotation.list";
};

void read(CheckedJson& in, AnnotationSetting& out);
void read(CheckedJson& in, AnnotationDelete& out);

} // namespace wakesurf::protocol
