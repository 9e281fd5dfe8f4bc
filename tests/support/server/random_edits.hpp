// Random edits by three participants, one after the other: the same seed makes the same ones.
#pragma once

#include "tests/support/server/session_bench.hpp"

#include <random>

namespace wakesurf::tests {

class RandomEdits {
  public:
    RandomEdits(SessionBench& bench, std::uint64_t seed) : bench_(bench), random_(seed) {}

    /// Makes one edit, or a refused one.
    void step() {
        server::Session& session = *bench_.session;
        server::Author author = some_author();
        if (random_() % 3 == 0)
            author.gesture = random_() % 2 == 0 ? "slide" : "paint";
        switch (random_() % 20) {
        case 0:
        case 1:
            (void)session.set_rake(rake_at(coordinate()), author);
            break;
        case 2:
        case 3:
        case 4:
            (void)session.set_rake(
                coloured(dragged(coordinate(), some(server::RecordType::Rake), some_flag())),
                author);
            break;
        case 5:
            (void)session.remove({server::RecordType::Rake, some(server::RecordType::Rake)},
                                 author);
            break;
        case 6:
            (void)session.set_surface(surface_on(some(server::RecordType::Rake)), author);
            break;
        case 7:
            (void)session.set_surface(
                surface_on(some(server::RecordType::Rake), some(server::RecordType::Surface)),
                author);
            break;
        case 8:
            (void)session.remove({server::RecordType::Surface, some(server::RecordType::Surface)},
                                 author);
            break;
        case 9:
            (void)session.set_bookmark(
                bookmark_of("{\"n\":" + std::to_string(random_() % 9) + "}", some_or_new("b")),
                author);
            break;
        case 10:
            (void)session.remove({server::RecordType::Bookmark, some(server::RecordType::Bookmark)},
                                 author);
            break;
        case 11:
            (void)session.set_annotation(note(std::to_string(random_() % 9), some_or_new("a")),
                                         author);
            break;
        case 12:
            (void)session.remove(
                {server::RecordType::Annotation, some(server::RecordType::Annotation)}, author);
            break;
        case 15:
            (void)session.set_slice(slice_at(double(random_() % 9), some_or_new("c")), author);
            break;
        case 16:
            (void)session.remove({server::RecordType::Slice, some(server::RecordType::Slice)},
                                 author);
            break;
        case 17:
            (void)session.set_lines(lines_from(double(random_() % 9), some_or_new("l")), author);
            break;
        case 18:
            (void)session.remove({server::RecordType::Lines, some(server::RecordType::Lines)},
                                 author);
            break;
        case 13:
            (void)session.move_in_history(server::HistoryMove::Undo, author);
            break;
        case 14:
            (void)session.move_in_history(server::HistoryMove::Redo, author);
            break;
        default:
            bench_.loop.pass(std::chrono::milliseconds(random_() % 4000));
        }
    }

    const server::Author& some_author() {
        const server::Author* authors[] = {&bench_.ada, &bench_.bob, &bench_.script};
        return *authors[random_() % 3];
    }

  private:
    protocol::RakeSetting coloured(protocol::RakeSetting setting) {
        if (random_() % 3 == 0)
            setting.colour = random_() % 2 == 0 ? "#abcdef" : "#012345";
        return setting;
    }

    double coordinate() { return std::uniform_real_distribution<double>(-9, 9)(random_); }

    std::optional<bool> some_flag() {
        const std::uint64_t choice = random_() % 3;
        return choice == 0 ? std::nullopt : std::optional(choice == 1);
    }

    /// Returns the id of an existing record, or of none.
    std::string some(server::RecordType type) {
        std::vector<std::string> ids{"r999"};
        for (const server::Record& each : bench_.session->records().list())
            if (server::key_of(each).type == type)
                ids.push_back(server::key_of(each).id);
        return ids[random_() % ids.size()];
    }

    std::optional<std::string> some_or_new(const std::string& letter) {
        if (random_() % 2 == 0)
            return std::nullopt;
        return letter + std::to_string(1 + random_() % 9);
    }

    SessionBench& bench_;
    std::mt19937_64 random_;
};

} // namespace wakesurf::tests
