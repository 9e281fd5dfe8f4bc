// Checked access to the members of a JSON object: the first fault found is kept with the member's name,
// so that a reader states what it wants line by line and asks once at the end.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/base/json_table.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Holds a reference to the object; values of the wrong type read as empty and leave a fault.
class JsonMembers {
  public:
    explicit JsonMembers(const nlohmann::json& object);

    bool has(std::string_view name) const; ///< present and not null

    /// Reads a member of a type that a table may have.
    template <class Value>
    Value get(std::string_view name) {
        Value out{};
        if (const auto* value = find(name))
            if (const std::string wrong = read_back(*value, out); !wrong.empty())
                fault(name, wrong);
        return out;
    }

    std::string text(std::string_view name);
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
