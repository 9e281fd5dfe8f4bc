// Streamlines as files of the command line: .vtp for ParaView, and .csv with the columns that Python's Streamlines.to_csv writes, and the time of flight.
#pragma once

#include "core/surface/lines/stream_lines.hpp"

#include <string>

namespace wakesurf::protocol {

/// Returns polylines (VTK's XML) with the time of flight and the field at each point, NaN where it has no value, and the seed of each line.
/// @param field  its name. @param time  at which the lines hold
std::string lines_vtp(const core::StreamLines& lines, const std::string& field, double time);

/// Returns a line of names, and one with the line's number, the place, the time of flight and the value of each point; a value that is not
/// there is empty.
std::string lines_csv(const core::StreamLines& lines, const std::string& field);

/// Returns how many lines there are and why they end, and what was left out, in words.
std::string lines_words(const core::StreamLines& lines);

} // namespace wakesurf::protocol
