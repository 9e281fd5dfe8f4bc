// Checked access to the members of a JSON object: the first fault found is kept with the member's name,
// so that a reader states what it wants line by line and asks once at the end.
#pragma once

#include "core/base/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Holds a reference to the object; values of the wrong type read as empty and leave a fault.
class JsonMembers {
  public:
    explicit JsonMembers(const nlohmann::json& object);

    bool has(std::string_view name) const; ///< present and not null
    std::string text(std::string_view name);
    bool flag(std::string_view name);
    double number(std::string_view name); ///< finite
    std::uint64_t count(std::string_view name,
                        std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
    std::int64_t integer(std::string_view name);
    std::vector<double> numbers(std::string_view name); ///< finite

    template <std::size_t N>
    std::array<double, N> numbers_of(std::string_view name) {
        std::array<double, N> out{};
        const auto found = numbers(name);
        if (found.size() == N)
            std::copy(found.begin(), found.end(), out.begin());
        else
            fault(name, "must have " + std::to_string(N) + " numbers");
        return out;
    }

    const nlohmann::json& list(std::string_view name);   ///< an array, empty on a fault
    const nlohmann::json& object(std::string_view name); ///< an object, empty on a fault

    void fault(std::string_view name, std::string_view problem);

    /// Corrupt with the first fault, or nothing.
    core::Result<void> verdict() const;

  private:
    const nlohmann::json* find(std::string_view name);

    const nlohmann::json& object_;
    std::string fault_;
};

} // namespace wakesurf::protocol
