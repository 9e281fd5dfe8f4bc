// Rows of a state folder's database, as a start reads them: lines of `type TAB id TAB record`. What a start brings back, the next start
// brings back whole.
#include "server/sessions/records/record_entries.hpp"
#include "tests/fuzz/targets/all.hpp"

#include <algorithm>

namespace wakesurf::fuzz {

namespace {

std::vector<server::JournalEntry> rows(std::string_view text) {
    std::vector<server::JournalEntry> out;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto first = line.find('\t');
        const auto second = line.find('\t', first == line.npos ? first : first + 1);
        if (second == line.npos)
            continue;
        out.push_back({std::string(line.substr(0, first)),
                       std::string(line.substr(first + 1, second - first - 1)),
                       std::string(line.substr(second + 1))});
    }
    return out;
}

std::string line_of(const server::JournalEntry& entry) {
    return entry.type + '\t' + entry.id + '\t' + entry.record.value_or("") + '\n';
}

void run(Input input) {
    const auto kept = server::read_entries(rows(text_of(input)));
    const auto records = kept.records.list();
    std::vector<server::JournalEntry> written;
    for (const auto& record : records)
        written.push_back(server::entry_of(record));
    const auto again = server::read_entries(written);
    demand(again.report.refused.empty(), "what a start brought back, the next one brings back");
    demand(again.records.list().size() == records.size(), "no record is lost between two starts");
}

std::vector<std::string> seeds() {
    protocol::RakeRecord rake;
    rake.rake = "rake-1";
    rake.rev = 2;
    rake.shape.points = {{0, 0, 0}, {1, 0.1, 0}};
    rake.shape.seeds = 8;
    protocol::SurfaceRecord surface;
    surface.surface = "surface-1";
    surface.rake = rake.rake;
    surface.dataset = "d";
    const std::string head =
        line_of(server::entry_of(protocol::SessionHead{"main", 5, 2, 2, 1, 1}));
    const std::string both = line_of(server::entry_of(server::Record(rake))) +
                             line_of(server::entry_of(server::Record(surface)));
    return {head + both, both, head + line_of(server::entry_of(protocol::ClockRecord{})),
            "rake\trake-9\t{}\nunknown\tx\ty\n"};
}

} // namespace

const Target journal_rows_target{"journal_rows", run, seeds, true};

} // namespace wakesurf::fuzz
