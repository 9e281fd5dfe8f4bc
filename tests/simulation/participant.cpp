#include "tests/simulation/participant.hpp"

#include "protocol/api/plural.hpp"
#include "protocol/wire/mesh_frame.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace wakesurf::simulation {

using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr const char* session = "main";

/// What people who edit at the same time must expect: stale, leased, gone meanwhile, outside, over a limit.
bool expected(int code) {
    return code == -32801 || code == -32011 || code == -32004 || code == -32012 || code == -32014;
}

} // namespace

Participant::Records records_of(const json& snapshot) {
    Participant::Records records;
    for (const std::string type : {"rake", "surface", "slice", "lines", "bookmark", "annotation"})
        for (const json& record : snapshot[protocol::plural_of(type)])
            records[{type, record[type]}] = record; // its id is the member called like its type
    records[{"clock", "clock"}] = snapshot["clock"];
    return records;
}

Participant::Participant(World& world, std::string name, Dial dial)
    : world_(world), name_(std::move(name)), dial_(std::move(dial)),
      acknowledges_(world.chance(0.8)) {}

void Participant::connect() {
    link_ = dial_();
    if (!link_) {
        world_.after(world_.time_between(20ms, 200ms), [this] { connect(); });
        return;
    }
    link_->attach(
        Link::Client, [this](Message message) { received(std::move(message)); },
        [this, link = std::weak_ptr(link_)] {
            if (link.lock() != link_)
                return;
            link_.reset();
            ++losses_;
            joined_ = false;
            asked_.clear();
            world_.after(world_.time_between(5ms, 100ms), [this] { connect(); });
        });
    json join{{"session", session}, {"name", name_}};
    if (!resume_token_.empty()) {
        join["resumeToken"] = resume_token_;
        join["lastSeq"] = seq_;
    }
    call("session.join", std::move(join), [this](const json& result) { joined(result); });
}

void Participant::lose_connection() {
    if (link_)
        link_->cut();
}

void Participant::call(const std::string& method, json parameters, Answer then) {
    const int id = next_id_++;
    asked_[id] = std::move(then);
    link_->send(
        Link::Server,
        json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(parameters)}}
            .dump());
}

void Participant::notify(const std::string& method, json parameters) {
    link_->send(
        Link::Server,
        json{{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(parameters)}}.dump());
}

void Participant::received(Message message) {
    if (const auto* frame = std::get_if<std::vector<std::byte>>(&message))
        return folded(*frame);
    const json text = json::parse(std::get<std::string>(message));
    if (text.contains("method"))
        return told(text["method"], text["params"]);
    const auto asked = asked_.extract(text.value("id", 0));
    if (asked.empty())
        return wrong("an answer to nothing: " + text.dump());
    if (text.contains("result")) {
        if (asked.mapped())
            asked.mapped()(text["result"]);
    } else if (!expected(text["error"]["code"])) {
        wrong("the server answers " + text.dump());
    }
}

void Participant::told(const std::string& method, const json& parameters) {
    if (method != "session.patched" || !joined_)
        return;
    if (parameters["seq"] != seq_ + 1)
        wrong("patch " + parameters["seq"].dump() + " came after " + std::to_string(seq_));
    seq_ = parameters["seq"];
    patched(parameters["patches"]);
}

void Participant::joined(const json& result) {
    joined_ = true;
    // As the page does: a server that does not give the token back may call other states by the same numbers.
    if (std::exchange(resume_token_, result["resumeToken"]) != resume_token_)
        subscriptions_.clear();
    for (auto& [surface, subscription] : subscriptions_)
        subscription.asked = false;
    if (result.value("resumed", false)) {
        ++resumed_;
        patched(result["patches"]);
    } else {
        records_ = records_of(result["snapshot"]);
    }
    seq_ = result["seq"];
    std::erase_if(subscriptions_, [this](const auto& each) {
        return !records_.contains({"surface", each.first});
    });
    subscribe_to_new();
}

void Participant::patched(const json& patches) {
    for (const json& patch : patches) {
        const std::pair key{patch["type"].get<std::string>(), patch.value("id", std::string())};
        if (patch["op"] == "put") {
            records_[key] = patch["record"];
        } else {
            records_.erase(key);
            if (key.first == "surface")
                subscriptions_.erase(key.second);
        }
    }
    subscribe_to_new();
}

void Participant::subscribe_to_new() {
    for (const auto& [key, record] : records_)
        if (key.first == "surface" && !subscriptions_[key.second].asked)
            subscribe(key.second);
}

void Participant::subscribe(const std::string& surface) {
    Subscription& subscription = subscriptions_[surface];
    subscription.asked = true;
    json parameters{{"surface", surface}};
    if (subscription.decoder.newest() && !subscription.decoder.needs_key()) {
        const auto& header = subscription.decoder.newest()->header;
        parameters["from"] = {{"epoch", header.epoch}, {"seq", header.seq}};
    }
    call("surface.subscribe", std::move(parameters), [this, surface](const json& result) {
        const auto found = subscriptions_.find(surface);
        if (found == subscriptions_.end())
            return;
        if (!result["resumed"].get<bool>())
            found->second.decoder = {};
        found->second.number = result["subscription"];
    });
}

void Participant::folded(std::span<const std::byte> bytes) {
    const auto frame = protocol::read_frame(bytes);
    if (!frame)
        return wrong("a frame cannot be read: " + frame.error().message);
    const auto found =
        std::find_if(subscriptions_.begin(), subscriptions_.end(),
                     [&](const auto& each) { return each.second.number == frame->header.surface; });
    if (found == subscriptions_.end())
        return; // of a surface deleted meanwhile
    const auto whole = found->second.decoder.fold(bytes);
    if (!whole)
        return wrong("a frame does not fit: " + whole.error().message);
    if (*whole && !frame->header.is_key())
        ++deltas_;
    if (*whole && acknowledges_ && world_.chance(0.9))
        notify("frame.ack", {{"subscription", frame->header.surface},
                             {"epoch", frame->header.epoch},
                             {"seq", frame->header.seq}});
}

const protocol::DecodedState* Participant::state(const std::string& surface) const {
    const auto found = subscriptions_.find(surface);
    if (found == subscriptions_.end() || !found->second.decoder.newest())
        return nullptr;
    return &*found->second.decoder.newest();
}

void Participant::start_editing(Duration every) {
    every_ = every;
    if (!std::exchange(editing_, true))
        world_.after(world_.time_between(0us, every), [this] { edit(); });
}

void Participant::edit() {
    if (!editing_)
        return;
    if (joined_) {
        ++edits_;
        const auto what = world_.pick(100);
        if (what < 42) {
            edit_rake();
        } else if (what < 62) {
            edit_surface();
        } else if (what < 69) {
            const std::string type = world_.chance(0.5) ? "rake" : "surface";
            if (const auto id = any(type))
                call(type + ".delete", {{type, *id}});
        } else if (what < 77) {
            call(world_.chance(0.6) ? "history.undo" : "history.redo", json::object());
        } else if (what < 82) {
            call("annotation.set", {{"text", "look"}, {"position", {world_.between(-5, 5), 0, 0}}},
                 [this](const json& result) {
                     remember("annotation", result["annotation"], result);
                 });
        } else if (what < 88) {
            move_clock();
        } else if (what < 91) {
            notify("presence.update", {{"pointer", {world_.between(-5, 5), 0, 0}}});
        } else {
            lose_connection(); // and comes back
        }
    }
    world_.after(world_.time_between(every_ / 2, every_ * 2), [this] { edit(); });
}

void Participant::edit_rake() {
    const double x = world_.between(-8, 8);
    json rake{
        {"kind", "line"}, {"points", {{x, -1, 0}, {x, 1, 0.5}}}, {"seeds", 2 + world_.pick(4)}};
    if (const auto id = any("rake"); id && !(world_.chance(0.2) && few("rake"))) {
        rake["rake"] = *id;
        if (world_.chance(0.3))
            rake["dragging"] = world_.chance(0.7);
        if (world_.chance(0.2))
            rake["ifRev"] = records_[{"rake", *id}]["rev"];
    }
    if (world_.chance(0.3))
        rake["gesture"] = "hand";
    call("rake.set", std::move(rake),
         [this](const json& result) { remember("rake", result["rake"], result); });
}

void Participant::edit_surface() {
    const auto rake = any("rake");
    if (!rake)
        return edit_rake();
    static constexpr std::array kinds{"stream", "path", "streak", "time"};
    json surface{{"rake", *rake},
                 {"kind", kinds[world_.pick(kinds.size())]},
                 {"dataset", "flow"},
                 {"from", 0},
                 {"to", world_.between(0.5, 3)},
                 {"separation", 1}};
    if (surface["kind"] == "time")
        surface["sweep"] = {0.5, 0.0, 0.0};
    if (const auto id = any("surface"); id && !(world_.chance(0.3) && few("surface")))
        surface["surface"] = *id;
    if (world_.chance(0.3))
        surface["gesture"] = "hand";
    call("surface.set", std::move(surface),
         [this](const json& result) { remember("surface", result["surface"], result); });
}

void Participant::move_clock() {
    const auto what = world_.pick(3);
    if (what == 0)
        call("time.set", {{"time", world_.between(0, 3)}});
    else if (what == 1)
        call("time.play", {{"speed", 1}, {"loop", true}, {"from", 0}, {"to", 3}});
    else
        call("time.pause", json::object());
}

void Participant::remember(const std::string& type, const std::string& id, const json& result) {
    if (result.value("durable", false))
        acknowledged_.push_back({type, id, result["rev"]});
}

std::optional<std::string> Participant::any(const std::string& type) {
    std::vector<std::string> ids;
    for (const auto& [key, record] : records_)
        if (key.first == type)
            ids.push_back(key.second);
    if (ids.empty())
        return std::nullopt;
    return ids[world_.pick(ids.size())];
}

bool Participant::few(const std::string& type) const {
    return std::count_if(records_.begin(), records_.end(),
                         [&](const auto& each) { return each.first.first == type; }) < 4;
}

void Participant::wrong(const std::string& what) {
    if (trouble_.empty())
        trouble_ = name_ + ": " + what;
}

} // namespace wakesurf::simulation
