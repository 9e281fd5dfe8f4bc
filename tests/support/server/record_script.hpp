// Random edits of sessions' records beside a map that takes the same edits: the expected content of a store
// after each of them.
#pragma once

#include "server/base/journal.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace wakesurf::tests {

using RecordMap = std::map<std::tuple<std::string, std::string, std::string>, std::string>;

inline RecordMap
records_of(const std::map<std::string, std::vector<server::JournalEntry>>& sessions) {
    RecordMap out;
    for (const auto& [session, entries] : sessions)
        for (const server::JournalEntry& each : entries)
            out[{session, each.type, each.id}] = each.record.value_or("(deleted)");
    return out;
}

struct ScriptedEdit {
    std::string session;
    std::vector<server::JournalEntry> entries; ///< none: the session goes
};

/// Makes edits. Every edit is another state: it counts itself in a record.
class RecordScript {
  public:
    explicit RecordScript(std::uint64_t seed) : random_(seed) {}

    /// Returns the next edit; the history has the state after it.
    ScriptedEdit next() {
        ScriptedEdit edit{"session-" + std::to_string(random_() % 4), {}};
        RecordMap state = history_.back();
        if (random_() % 16 == 0) {
            std::erase_if(
                state, [&](const auto& each) { return std::get<0>(each.first) == edit.session; });
        } else {
            const std::set<std::string> types{"rake", "surface", "bookmark"};
            for (const std::string& type : types)
                if (random_() % 2 == 0)
                    edit.entries.push_back({type, std::to_string(random_() % 8), value()});
            edit.entries.push_back({"session", "count", std::to_string(history_.size())});
            for (const auto& [type, id, record] : edit.entries)
                if (record)
                    state[{edit.session, type, id}] = *record;
                else
                    state.erase({edit.session, type, id});
        }
        history_.push_back(std::move(state));
        return edit;
    }

    /// Returns the states, by the number of edits made.
    const std::vector<RecordMap>& history() const { return history_; }

    const RecordMap& now() const { return history_.back(); }

    std::mt19937_64& random() { return random_; }

  private:
    std::optional<std::string> value() {
        if (random_() % 4 == 0)
            return std::nullopt;
        // Some larger than a page of the file.
        const std::size_t size = random_() % 8 == 0 ? 9000 : random_() % 60;
        return "\"" + std::string(size, static_cast<char>('a' + random_() % 26)) + "\"";
    }

    std::mt19937_64 random_;
    std::vector<RecordMap> history_{{}};
};

} // namespace wakesurf::tests
