// Session files: what is exported comes back as it was, and a file that anybody may have written does no harm.
#include "protocol/api/base/json_text.hpp"
#include "server/base/limits.hpp"
#include "server/sessions/session_exchange.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests::session_exchange_test {

using core::Error;
using nlohmann::json;

namespace {

json exported(SessionBench& bench, const server::Session& session) {
    return protocol::session_file_json(
        server::file_of(server::snapshot_of(session, bench.datasets, bench.wall)));
}

core::Result<std::shared_ptr<server::Session>> imported(SessionBench& bench, const json& file) {
    auto read = server::read_session_text(file.dump());
    if (!read)
        return tl::unexpected(read.error());
    return bench.sessions.import(std::move(read->records), "");
}

/// Something of everything, with numbers that are no short decimals, and ids with gaps.
void fill(SessionBench& bench) {
    server::Session& session = *bench.session;
    ASSERT_TRUE(session.set_rake(rake_at(0), bench.ada));
    ASSERT_TRUE(session.set_rake(rake_at(1.0 / 3), bench.ada));
    ASSERT_TRUE(session.set_rake(rake_at(2), bench.bob));
    ASSERT_TRUE(session.remove({server::RecordType::Rake, "r1"}, bench.ada));
    auto surface = surface_on("r2");
    surface.parameters.to = 0.1 + 0.2;
    ASSERT_TRUE(session.set_surface(surface, bench.ada));
    ASSERT_TRUE(session.set_rake(rake_at(1.0 / 7, "r2"), bench.ada));
    ASSERT_TRUE(session.set_bookmark(bookmark_of(R"({"camera":[1,2.5]})"), bench.ada));
    ASSERT_TRUE(session.set_slice(slice_at(1.0 / 3), bench.ada));
    ASSERT_TRUE(session.set_lines(lines_from(1.0 / 3), bench.ada));
    auto text = note("two\nlines, and \u00fc");
    text.surface = "s1";
    ASSERT_TRUE(session.set_annotation(text, bench.bob));
    session.clock().set(0.125);
}

} // namespace

TEST(SessionExchange, ATwinOfAnExportedSessionExportsTheSame) {
    SessionBench bench;
    fill(bench);
    bench.session->rename("vortex");
    const json file = exported(bench, *bench.session);
    bench.wall += 60;
    const auto twin = imported(bench, file);
    ASSERT_TRUE(twin) << twin.error().message;
    json again = exported(bench, **twin);
    EXPECT_NE(again["exported"], file["exported"]);
    again["exported"] = file["exported"];
    EXPECT_EQ(again, file);
    EXPECT_EQ((*twin)->name(), "vortex");
    EXPECT_TRUE((*twin)->profile().edited);
    EXPECT_EQ((*twin)->set_rake(rake_at(3), bench.ada)->record.rake, "r4") << "ids are given once";
}

TEST(SessionExchange, AnImportedSessionIsThereAfterARestart) {
    SessionBench bench;
    fill(bench);
    const auto twin = imported(bench, exported(bench, *bench.session));
    ASSERT_TRUE(twin);
    SessionBench after;
    after.sessions.restore((*twin)->id(), "", bench.journal.entries((*twin)->id()));
    EXPECT_EQ(content((*after.sessions.find((*twin)->id()))->records()),
              content((*twin)->records()));
}

TEST(SessionExchange, AFileNamesItsDatasetsSoThatOthersAreNoticed) {
    SessionBench bench;
    fill(bench);
    json file = exported(bench, *bench.session);
    ASSERT_EQ(file["datasets"].size(), 1u);
    EXPECT_EQ(file["datasets"][0]["dataset"], "abc");
    EXPECT_EQ(file["datasets"][0]["fingerprint"].get<std::string>().size(), 64u);
    const auto notes = [&] {
        return server::dataset_notes(*server::read_session_text(file.dump()), bench.datasets);
    };
    EXPECT_TRUE(notes().empty());
    file["datasets"][0]["fingerprint"] = std::string(64, '0');
    ASSERT_EQ(notes().size(), 1u);
    EXPECT_NE(notes()[0].find("s1"), std::string::npos) << notes()[0];
    file["datasets"] = json::array();
    EXPECT_TRUE(notes().empty()) << "nothing is known of them";
    bench.datasets.there = false;
    ASSERT_EQ(notes().size(), 1u);
    EXPECT_NE(notes()[0].find("abc"), std::string::npos);
    const auto made = imported(bench, file);
    ASSERT_TRUE(made) << "the surface waits for its dataset";
    EXPECT_EQ((*made)->records().all<protocol::SurfaceRecord>().size(), 1u);
}

TEST(SessionExchange, FilesThatAreNoneOrHostileAreRefusedWholeAndSayWhy) {
    SessionBench bench;
    fill(bench);
    const json good = exported(bench, *bench.session);
    const auto changed = [&good](const std::string& pointer, const json& value) {
        json file = good;
        file[json::json_pointer(pointer)] = value;
        return file.dump();
    };
    json twice = good;
    twice["records"]["rakes"].push_back(twice["records"]["rakes"][0]);
    json many = good;
    for (std::size_t i = 0; i <= server::limits::rakes; ++i) {
        many["records"]["rakes"].push_back(good["records"]["rakes"][0]);
        many["records"]["rakes"].back()["rake"] = "r" + std::to_string(100 + i);
    }
    const std::vector<std::pair<std::string, std::string>> files{
        {"nothing", ""},
        {"no JSON", "not a file"},
        {"another JSON", R"({"sessions":[]})"},
        {"a list", "[]"},
        {"too deep", std::string(60, '[') + std::string(60, ']')},
        {"too many values", "[" + std::string(std::size_t{9} << 20, ',') + "]"},
        {"no records", changed("/records", nullptr)},
        {"a group that is no list", changed("/records/rakes", json::object())},
        {"a missing group", changed("/records/surfaces", nullptr)},
        {"a record that is a number", changed("/records/rakes/0", 7)},
        {"a record without its id", changed("/records/rakes/0/rake", nullptr)},
        {"an id that is none", changed("/records/rakes/0/rake", "../../etc")},
        {"an id far up", changed("/records/rakes/0/rake", "r99999999999999999999")},
        {"an id twice", twice.dump()},
        {"more rakes than there may be", many.dump()},
        {"a rake of equal points", changed("/records/rakes/0/points", {{0, 0, 0}, {0, 0, 0}})},
        {"a rake of one point", changed("/records/rakes/0/points", {{0, 0, 0}})},
        {"a number beyond floats", changed("/records/rakes/0/points/0/0", 1e300)},
        {"a billion seeds", changed("/records/rakes/0/seeds", 1'000'000'000)},
        {"a surface without its rake", changed("/records/surfaces/0/rake", "r77")},
        {"a kind that is none", changed("/records/surfaces/0/kind", "magic")},
        {"a clock that is none", changed("/records/clock", "noon")},
        {"a view that is too long",
         changed("/records/bookmarks/0/view", {{"x", std::string(5000, 'x')}})},
    };
    for (const auto& [what, text] : files) {
        const auto read = server::read_session_text(text);
        ASSERT_FALSE(read) << what;
        EXPECT_TRUE(read.error().code == Error::Code::InvalidArgument ||
                    read.error().code == Error::Code::OverLimit)
            << what << ": " << read.error().message;
        EXPECT_FALSE(read.error().message.empty()) << what;
    }
    const auto deep =
        server::read_session_text(std::string(60, '[') + std::string(60, ']')).error();
    EXPECT_EQ(deep.code, Error::Code::InvalidArgument) << "to ask again is of no use";
    EXPECT_FALSE(deep.hint.empty());
    EXPECT_EQ(server::read_session_text(changed("/wakesurfSession", 2)).error().code,
              Error::Code::Unsupported);
    EXPECT_TRUE(server::read_session_text(changed("/later", "wakesurf's"))) << "left to newer ones";
}

TEST(SessionExchange, NamesFromAFileAreMadeFitToBeSeen) {
    SessionBench bench;
    json file = exported(bench, *bench.session);
    file["name"] = "a\u202e\u0007b" + std::string(500, 'c');
    const auto made = imported(bench, file);
    ASSERT_TRUE(made);
    EXPECT_EQ((*made)->name().substr(0, 3), "abc");
    EXPECT_LE((*made)->name().size(), server::limits::name_bytes);
}

} // namespace wakesurf::tests::session_exchange_test
