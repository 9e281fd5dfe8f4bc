// Changes within JSON that leave it JSON: bytes changed at random seldom do, and would try little but the
// parser. It is done on the text, because libFuzzer wants a mutation for every run.
#pragma once

#include "tests/fuzz/json_spans.hpp"
#include "tests/fuzz/random.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::fuzz {

class JsonMutation {
  public:
    /// Takes the texts from which values are inserted.
    explicit JsonMutation(const std::vector<std::string>& seeds);

    /// Returns `text`, or the JSON at the end of one of its lines, with some values changed, left out, added
    /// or moved. Empty without JSON.
    std::optional<std::string> operator()(std::string_view text, Random& random) const;

  private:
    struct Donor {
        std::string key; ///< with its quotes; empty within an array
        std::string value;
    };

    void change(std::string& json, Random& random) const;
    void put_member(std::string& json,
                    const std::vector<JsonSpan>& spans,
                    std::size_t object,
                    Random& random) const;
    const std::string& any_value(Random& random) const;

    std::vector<Donor> donors_;
};

} // namespace wakesurf::fuzz
