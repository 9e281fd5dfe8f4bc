// The description of time means of a field beside their values: what was averaged over which times, and the
// scalar fields that came of it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace wakesurf::core {

/// Behind the name of a velocity: the kinetic energy of its fluctuation.
inline constexpr const char* energy_suffix = "_k";

struct MeanField {
    std::string name;                      ///< as fields are called: p_mean
    std::array<double, 2> range{0.0, 0.0}; ///< of its values

    bool operator==(const MeanField&) const = default;
};

struct MeanRecord {
    std::string of;         ///< the field that was averaged
    std::string label;      ///< behind the names of its fields; often empty
    double from = 0.0;      ///< time of the first time-step that counts
    double to = 0.0;        ///< and of the last
    std::size_t steps = 0;  ///< how many time-steps count
    double period = 0.0;    ///< of phase means; 0: the mean and the rms of all
    std::size_t phases = 0; ///< phase means of a period; 0 without one
    std::string version;    ///< of the program
    std::vector<MeanField> fields;

    /// Says whether the other has the same values, made of the same data.
    bool same_values(const MeanRecord& other) const {
        return of == other.of && label == other.label && from == other.from && to == other.to &&
               steps == other.steps && period == other.period && phases == other.phases;
    }

    /// Says whether a field is the kinetic energy of the fluctuation of a velocity, which has another unit.
    bool is_energy(const MeanField& field) const {
        return field.name == of + energy_suffix + (label.empty() ? "" : "_" + label);
    }

    bool operator==(const MeanRecord&) const = default;
};

} // namespace wakesurf::core
