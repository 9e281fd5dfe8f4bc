// The numbers of a surface as CSV (RFC 4180): a line of names, with units where the data have them, and one a time.
#pragma once

#include "core/surface/measures/numbers_over_time.hpp"

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Returns the unit of a column, such as m^3/s; empty where the data have no units, or the number has none.
std::string
unit_of(const core::NamedNumber& column, std::string_view length_unit, std::string_view time_unit);

/// @param length_unit,time_unit  empty where the data have none. Numbers that are not known are empty.
std::string numbers_csv(const core::NumberTable& table,
                        std::string_view length_unit,
                        std::string_view time_unit);

} // namespace wakesurf::protocol
