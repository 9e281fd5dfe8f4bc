// Made by protocol/api/generate from rake.schema.json: do not edit.
// Rakes: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "core/surface/rake.hpp"
#include "protocol/api/checked_json.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// A rake as the session keeps it.
struct RakeRecord {
    /// its id
    std::string rake;
    /// counts the edits of a record
    std::uint64_t rev = 0;
    /// kind, points, seeds
    core::Rake shape;
    /// for people
    std::string name;
    /// #rrggbb
    std::string colour;
    /// the name of the one who made it
    std::string author;
    /// a part was outside the domain and is cut away
    bool clipped = false;
    /// someone holds it just now
    bool dragging = false;
    /// the participant who holds it; only while someone does
    std::string leased_by;

    bool operator==(const RakeRecord&) const = default;
};

void read(CheckedJson& in, RakeRecord& out);

nlohmann::json rake_json(const RakeRecord& record);

/// As it is kept: what read() reads.
nlohmann::json kept_json(const RakeRecord& record);

/// Parameters of rake.set: Creates a rake, or replaces one as a whole; the surfaces that hang on it
/// are rebuilt at once, unless only its name or colour changes.
struct RakeSetting {
    static constexpr std::string_view method = "rake.set";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// left out: create one
    std::optional<std::string> rake;
    /// kind, points, seeds
    core::Rake shape;
    /// for people
    std::string name;
    /// #rrggbb; left out: as it was, of a new rake one that few others have
    std::optional<std::string> colour;
    /// true: no one else may edit the rake for 5 s from now; false: they may again; left out: as it
    /// was
    std::optional<bool> dragging;
    /// a host's edit goes before someone else's lease
    bool force = false;
    /// true: only if no one has edited the session and there is no such record yet; it counts as no
    /// edit, so undo does not turn it
    bool default_scene = false;
    /// a name for what the user does; edits that follow each other with the same one are one step
    /// of undo
    std::optional<std::string> gesture;
    /// refuse the edit if the record is at another revision
    std::optional<std::uint64_t> if_rev;

    bool operator==(const RakeSetting&) const = default;
};

void read(CheckedJson& in, RakeSetting& out);

/// Parameters of rake.delete: Deletes a rake and the surfaces that hang on it.
struct RakeDelete {
    static constexpr std::string_view method = "rake.delete";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// an id from rake.list
    std::string rake;
    /// although someone else drags it; for hosts
    bool force = false;
    /// a name for what the user does; edits that follow each other with the same one are one step
    /// of undo
    std::optional<std::string> gesture;
    /// refuse the edit if the record is at another revision
    std::optional<std::uint64_t> if_rev;

    bool operator==(const RakeDelete&) const = default;
};

void read(CheckedJson& in, RakeDelete& out);

/// Parameters of rake.list: The rakes of a session.
struct RakeList {
    static constexpr std::string_view method = "rake.list";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const RakeList&) const = default;
};

void read(CheckedJson& in, RakeList& out);

} // namespace wakesurf::protocol
