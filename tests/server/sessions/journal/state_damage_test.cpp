// A file that was damaged on the disk, in some hundred ways: no one starts with fewer records without being told which, or
// that they are gone.
#include "server/sessions/journal/state_store.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace wakesurf::tests::state_damage_test {

using core::Error;
using server::PendingWrites;
using server::StateStore;

namespace {

constexpr std::size_t page = 4096;
constexpr int sessions = 4;
constexpr int rakes = 60;

using Keys = std::set<std::string>;

std::string key_text(const std::string& session, const std::string& type, const std::string& id) {
    return session + "/" + type + "/" + id;
}

std::string rake_text(int number, int round) {
    return R"({"rake":"r)" + std::to_string(number) + R"(","rev":)" + std::to_string(round) +
           R"(,"kind":"line","points":[[0.123456789,0.2,0.3],[1,2,3]],"seeds":32,"name":"rake )" +
           std::to_string(number) + R"("})";
}

PendingWrites round_of_edits(int round) {
    PendingWrites changes;
    for (int session = 0; session < sessions; ++session) {
        const std::string name = "session-" + std::to_string(session);
        changes.write(name, {{"session", "", R"({"name":"a"})"}});
        for (int number = 1 + round; number <= rakes; number += 3)
            changes.write(name, {{"rake", "r" + std::to_string(number), rake_text(number, round)}});
    }
    return changes;
}

/// The files of a state folder, as bytes.
struct Files {
    std::string file;
    std::string log;
    std::string mark;
};

class StateDamage : public testing::Test {
  protected:
    StateDamage() {
        auto store = StateStore::open(path);
        for (int round = 0; round < 3; ++round) {
            PendingWrites changes = round_of_edits(round);
            EXPECT_TRUE(store->apply(changes));
            if (round < 2) { // most is in the file, the newest in its log
                EXPECT_TRUE(store->hold());
                EXPECT_TRUE(store->release());
            }
        }
        killed = {read_file(path), read_file(path + "-wal"), read_file(path + ".commits")};
        for (int session = 0; session < sessions; ++session) {
            const std::string name = "session-" + std::to_string(session);
            all.insert(key_text(name, "session", ""));
            for (int number = 1; number <= rakes; ++number)
                all.insert(key_text(name, "rake", "r" + std::to_string(number)));
        }
        EXPECT_GT(killed.file.size(), 10 * page);
        EXPECT_GT(killed.log.size(), 4 * page);
        { const auto ending = std::move(store); }
        ended = {read_file(path), {}, read_file(path + ".commits")};
    }

    /// Starts with these files. Every record is there, or named as kept aside, or the start is refused and leaves the files alone.
    void start(const Files& files, const std::string& what) {
        std::filesystem::remove(path + "-wal");
        write_file(path, files.file);
        if (!files.log.empty())
            write_file(path + "-wal", files.log);
        write_file(path + ".commits", files.mark);
        auto store = StateStore::open(path);
        if (!store) {
            ++refused;
            EXPECT_NE(store.error().code, Error::Code::Io) << what << store.error().message;
            EXPECT_FALSE(store.error().hint.empty()) << what;
            EXPECT_EQ(read_file(path) == files.file, true) << what << ": the file was changed";
            EXPECT_EQ((files.log.empty() ? "" : read_file(path + "-wal")) == files.log, true)
                << what << ": the log was changed";
            return;
        }
        const StateStore::Loaded found = store->take_loaded();
        Keys there;
        for (const auto& [session, entries] : found.sessions)
            for (const auto& each : entries)
                there.insert(key_text(session, each.type, each.id));
        if (there == all) {
            ++whole;
            return;
        }
        ++aside;
        EXPECT_FALSE(found.damaged.empty()) << what << ": fewer records, and no one is told";
        for (const auto& each : found.damaged)
            there.insert(key_text(each.session, each.label.type, each.label.id));
        EXPECT_EQ(there, all) << what;
    }

    TemporaryFolder folder;
    std::string path = folder / "sessions.sqlite";
    Files killed; ///< as a server that was killed leaves them
    Files ended;  ///< as one that ended does
    Keys all;
    int refused = 0, whole = 0, aside = 0;
};

} // namespace

TEST_F(StateDamage, OfBitsIsToldOrHarmless) {
    std::mt19937_64 random(5);
    for (int flip = 0; flip < 150; ++flip) {
        Files files = flip % 2 == 0 ? ended : killed;
        std::string& bytes = flip % 2 == 1 && flip % 4 == 1 ? files.log : files.file;
        const std::size_t at = random() % bytes.size();
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        start(files, "bit flip " + std::to_string(flip) + " at " + std::to_string(at) + ": ");
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(aside, 0) << "a record's own bits";
    EXPECT_GT(whole, 0) << "what is no one's";
}

TEST_F(StateDamage, OfPagesIsToldOrHarmless) {
    for (std::size_t at = 0; at + page <= ended.file.size(); at += page)
        for (const char filling : {'\0', '\xff'}) {
            Files files = ended;
            files.file.replace(at, page, page, filling);
            start(files, "page at " + std::to_string(at) + ": ");
        }
    for (std::size_t at = 0; at + page <= killed.log.size(); at += page) {
        Files files = killed;
        files.log.replace(at, page, page, '\0');
        start(files, "page of the log at " + std::to_string(at) + ": ");
    }
    Files older = ended; // one page as it was before
    for (std::size_t at = page; at + page <= std::min(killed.file.size(), ended.file.size());
         at += page) {
        older.file = ended.file;
        older.file.replace(at, page, killed.file, at, page);
        start(older, "older page at " + std::to_string(at) + ": ");
    }
    EXPECT_GT(refused, 20);
}

TEST_F(StateDamage, OfLengthsIsTold) {
    for (std::size_t part = 0; part < 20; ++part) {
        Files files = ended;
        files.file.resize(files.file.size() * part / 20);
        start(files, "file of " + std::to_string(files.file.size()) + " bytes: ");
        files = killed;
        files.log.resize(files.log.size() * part / 20);
        start(files, "log of " + std::to_string(files.log.size()) + " bytes: ");
    }
    EXPECT_EQ(refused, 40) << "no length but the whole has everything";
}

TEST_F(StateDamage, OfOneRecordLeavesTheOthersInUseAndKeepsItsBytes) {
    Files files = ended;
    const std::size_t at = files.file.find("rake 17");
    ASSERT_NE(at, std::string::npos);
    files.file[at + 5] = '7';
    start(files, "one letter: ");
    EXPECT_EQ(aside, 1);
    for (int life = 0; life < 2; ++life) {
        auto store = StateStore::open(path);
        ASSERT_TRUE(store) << store.error().message;
        const auto found = store->take_loaded();
        EXPECT_TRUE(found.damaged.empty()) << "told once";
        ASSERT_EQ(found.aside.size(), 1u);
        EXPECT_EQ(found.aside[0].label.id, "r17");
        EXPECT_NE(found.aside[0].json.find("rake 77"), std::string::npos) << found.aside[0].json;
        PendingWrites again;
        again.write(found.aside[0].session, {{"rake", "r17", rake_text(17, life)}});
        EXPECT_TRUE(store->apply(again)) << "a new one of this id does not reach it";
    }
}

} // namespace wakesurf::tests::state_damage_test
