// Records as they are kept, in every reader: what is read can be written and read again to the same text.
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/record_text.hpp"
#include "tests/fuzz/targets/all.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::fuzz {

namespace {

template <class Record, class Write, class Read>
void check_twin(const core::Result<Record>& record, Write write, Read read) {
    if (!record)
        return;
    const std::string text = write(*record);
    const auto again = read(text);
    demand(again.has_value(), "a record that was written can be read");
    demand(write(*again) == text, "a record is the same after it was written and read");
}

void run(Input input) {
    const std::string_view text = text_of(input);
    if (!protocol::parse_json(text, {.bytes = std::size_t{1} << 20, .depth = 64}))
        return; // no reader takes it: all begin with this one
    const auto write = [](const auto& record) { return protocol::record_text(record); };
    const auto check = [&](auto parse) {
        check_twin(parse(text), write, [&](const std::string& again) { return parse(again); });
    };
    check([](auto t) { return protocol::parse_rake(t); });
    check([](auto t) { return protocol::parse_surface(t); });
    check([](auto t) { return protocol::parse_bookmark(t); });
    check([](auto t) { return protocol::parse_annotation(t); });
    check([](auto t) { return protocol::parse_clock(t); });
    check([](auto t) { return protocol::parse_session_head(t); });
    check([](auto t) { return protocol::parse_membership(t); });
    check([](auto t) { return protocol::parse_grant(t); });
    check([](auto t) { return protocol::parse_profile(t); });
}

std::vector<std::string> seeds() {
    protocol::RakeRecord rake;
    rake.rake = "r1";
    rake.rev = 3;
    rake.shape.points = {{0, 0, 0}, {1, 0.1, 0}};
    rake.shape.seeds = 32;
    rake.name = "wake";
    rake.colour = "#aabbcc";
    protocol::SurfaceRecord surface;
    surface.surface = "s1";
    surface.rake = "r1";
    surface.dataset = "d";
    surface.fields = {"p"};
    protocol::ClockRecord clock;
    clock.time = 0.5;
    protocol::BookmarkRecord bookmark;
    bookmark.bookmark = "b1";
    bookmark.view = R"({"camera":[1,2,3]})";
    const std::string digest(64, 'a');
    const protocol::MembershipRecord place{"Ada",  "#102030", "editor", "link",
                                           digest, true,      7,        digest};
    const protocol::GrantRecord grant{"viewer", digest, 5, "Ada", {"link"}, {{"p1", "viewer"}}};
    return {protocol::record_text(rake),
            protocol::record_text(surface),
            protocol::record_text(clock),
            protocol::record_text(protocol::SessionHead{"main", 7, 1, 2, 3, 4}),
            protocol::record_text(bookmark),
            protocol::record_text(protocol::AnnotationRecord{}),
            protocol::record_text(place),
            protocol::record_text(grant)};
}

} // namespace

const Target records_target{"records", run, seeds, true};

} // namespace wakesurf::fuzz
