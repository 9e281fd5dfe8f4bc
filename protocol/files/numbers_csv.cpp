#include "protocol/files/numbers_csv.hpp"

#include "protocol/files/csv_name.hpp"

#include <fmt/format.h>

#include <cmath>

namespace wakesurf::protocol {

namespace {

std::string power_of(std::string_view unit, int power) {
    return power == 1 ? std::string(unit) : fmt::format("{}^{}", unit, power);
}

} // namespace

std::string
unit_of(const core::NamedNumber& column, std::string_view length_unit, std::string_view time_unit) {
    if (!column.unit.empty())
        return column.unit;
    if ((column.length != 0 && length_unit.empty()) || (column.time != 0 && time_unit.empty()))
        return {};
    std::string out;
    if (column.length != 0)
        out = power_of(length_unit, column.length);
    if (column.time > 0)
        out += power_of(time_unit, column.time);
    else if (column.time < 0)
        out += "/" + power_of(time_unit, -column.time);
    return out;
}

std::string numbers_csv(const core::NumberTable& table,
                        std::string_view length_unit,
                        std::string_view time_unit) {
    std::string out;
    for (const core::NamedNumber& column : table.columns) {
        const std::string unit = unit_of(column, length_unit, time_unit);
        const std::string name =
            unit.empty() ? column.name : fmt::format("{} [{}]", column.name, unit);
        out += (name.find_first_of(",\"\r\n") == std::string::npos ? name : csv_name(name)) + ",";
    }
    const bool notes = !table.notes.empty();
    if (notes)
        out += "notes\n";
    else if (!out.empty())
        out.back() = '\n';
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        for (const double value : table.rows[i])
            out += std::isfinite(value) ? fmt::format("{},", value) : ",";
        if (!notes) {
            out.back() = '\n';
            continue;
        }
        std::string told;
        for (const std::string& note : table.notes[i])
            told += (told.empty() ? "" : "; ") + note;
        out += (told.empty() ? "" : csv_name(told)) + "\n";
    }
    return out;
}

} // namespace wakesurf::protocol
