// Notices to people, server.notice: of the disk, of a start after crashes, of data that were replaced, and of
// records that could not be used.
#pragma once

#include "core/base/result.hpp"
#include "server/sessions/session.hpp"

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Returns a whole server.notice, for people. @param level  `info` or `warning`
std::string notice(std::string_view kind, std::string_view level, const std::string& text);

/// Returns the notice of kind `durableAgain`, or with an error `notDurable`: edits are not kept for now.
std::string durability_notice(const core::Result<void>& turn);

/// Says why surfaces that were brought back are not computed, after so many starts that died.
core::Error withheld(unsigned died);

/// Returns the notice that says so.
std::string careful_notice(unsigned died);

/// Returns the notice that the values of datasets are others than before. @param names  of the datasets; at
/// least one
std::string replaced_data_notice(const std::set<std::string>& names);

/// Returns the same for participants who join a session after it has happened.
std::string replaced_data_meanwhile_notice(const std::set<std::string>& names);

/// Returns the newest of the records that were kept aside, at most so many.
std::span<const KeptAside> newest_aside(const Session& session, std::size_t most);

/// Returns the notice of records that could not be used when the server started; nothing where it could use
/// all.
std::optional<std::string> kept_aside_notice(const Session& session);

} // namespace wakesurf::server
