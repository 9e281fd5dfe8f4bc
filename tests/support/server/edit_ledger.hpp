// Random edits of one client, and the server's obligations after a crash: every answered edit, and of the
// others each whole or not at all.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace wakesurf::tests {

/// Makes edits. Each leaves a mark of its own in the record it sets (a rake's name, a surface's maxQuads), by
/// which it is recognized.
class EditLedger {
  public:
    explicit EditLedger(std::uint64_t seed) : random_(seed) {}

    struct Edit {
        std::size_t number = 0;
        std::string method;
        nlohmann::json parameters;
    };

    Edit next();

    /// Takes the answer to an edit; an error counts as an edit that was not made.
    void answered(std::size_t number, const nlohmann::json& message);

    std::size_t answers() const { return answers_; }

    /// Returns what is wrong with a `session.state`, in words; the ledger then continues from that state.
    std::vector<std::string> settle(const nlohmann::json& state);

    std::mt19937_64& random() { return random_; }

  private:
    using Mark = std::optional<std::string>; ///< nothing: there is no such record

    struct Record {
        std::map<std::size_t, Mark> edits; ///< from the newest answered one on
        std::optional<std::size_t> answered;
        bool going = false; ///< a deletion has been asked for
    };

    struct Sent {
        std::string type;
        std::string id; ///< empty: the answer will tell
        Mark mark;
    };

    Edit set(const std::string& type, const std::string& id);
    Edit erase(const std::string& id);
    Edit note(std::string method, nlohmann::json parameters, Sent sent);
    std::string choose();
    void compare(const std::string& type,
                 const std::map<std::string, std::string>& found,
                 std::vector<std::string>& wrong);

    std::mt19937_64 random_;
    std::size_t next_ = 1;
    std::size_t answers_ = 0;
    std::string anchor_; ///< the rake the surfaces hang on; never deleted
    std::map<std::size_t, Sent> sent_;
    std::map<std::string, std::map<std::string, Record>> records_; ///< by type and id
};

} // namespace wakesurf::tests
