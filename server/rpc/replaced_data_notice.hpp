// What people are told when the values of a dataset are others than before.
#pragma once

#include <set>
#include <string>

namespace wakesurf::server {

/// A whole `server.notice`. @param names  of the datasets; at least one
std::string replaced_data_notice(const std::set<std::string>& names);

/// The same for those who come to a session after it has happened.
std::string replaced_data_meanwhile_notice(const std::set<std::string>& names);

} // namespace wakesurf::server
