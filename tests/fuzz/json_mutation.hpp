// Changes within JSON that leave it JSON: bytes changed at random seldom do, and would try little but the parser.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::fuzz {

class JsonMutation {
  public:
    /// What is put into other texts comes out of these.
    explicit JsonMutation(const std::vector<std::string>& seeds);

    /// `text`, or the JSON at the end of one of its lines, with some values changed, left out, added or put elsewhere. Nothing where that
    /// is no JSON.
    std::optional<std::string> operator()(std::string_view text, std::mt19937& random) const;

  private:
    struct Donor {
        std::string key; ///< empty within an array
        nlohmann::json value;
    };

    void collect(const nlohmann::json& value);
    void change(nlohmann::json& value, std::mt19937& random) const;
    nlohmann::json any_value(std::mt19937& random) const;
    void change_here(nlohmann::json& value, std::mt19937& random) const;

    std::vector<Donor> donors_;
};

} // namespace wakesurf::fuzz
