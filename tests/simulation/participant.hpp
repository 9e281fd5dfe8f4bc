// A client of a simulated server: mirrors the session's records and folds the frames of its surfaces as the
// page does, edits at random, loses its connection and comes back. Its state must always be the server's.
#pragma once

#include "protocol/wire/mesh_decoder.hpp"
#include "tests/simulation/link.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace wakesurf::simulation {

/// Opens a connection to the server, or returns nothing while it is down.
using Dial = std::function<std::shared_ptr<Link>()>;

/// An edit the server has acknowledged as durable.
struct Acknowledged {
    std::string type, id;
    std::uint64_t rev = 0;
};

class Participant {
  public:
    Participant(World& world, std::string name, Dial dial);

    void connect();

    /// Cuts the connection; it comes back by itself.
    void lose_connection();

    /// Makes edits from now on, about one each `every`.
    void start_editing(Duration every);

    void stop_editing() { editing_ = false; }

    bool connected() const { return joined_; }

    const std::string& name() const { return name_; }

    /// The records by type and id.
    using Records = std::map<std::pair<std::string, std::string>, nlohmann::json>;

    const Records& records() const { return records_; }

    /// Returns the newest state of a surface; null before the first.
    const protocol::DecodedState* state(const std::string& surface) const;

    const std::vector<Acknowledged>& acknowledged() const { return acknowledged_; }

    /// Returns the fault it found; the test fails unless it is empty.
    const std::string& trouble() const { return trouble_; }

    std::size_t edits() const { return edits_; }

    /// Returns the number of folded updates that were not keys.
    std::size_t deltas() const { return deltas_; }

    std::size_t losses() const { return losses_; }

    /// Returns after how many lost connections the missed changes came instead of a snapshot.
    std::size_t resumed() const { return resumed_; }

  private:
    struct Subscription {
        std::uint32_t number = 0;
        protocol::MeshDecoder decoder;
        bool asked = false; ///< the answer to surface.subscribe is on its way
    };

    using Answer = std::function<void(const nlohmann::json& result)>;

    void call(const std::string& method, nlohmann::json parameters, Answer then = {});
    void notify(const std::string& method, nlohmann::json parameters);
    void received(Message message);
    void told(const std::string& method, const nlohmann::json& parameters);
    void joined(const nlohmann::json& result);
    void patched(const nlohmann::json& patches);
    void folded(std::span<const std::byte> bytes);
    void subscribe(const std::string& surface);
    void subscribe_to_new();
    void edit();
    void edit_rake();
    void edit_surface();
    void move_clock();
    void remember(const std::string& type, const std::string& id, const nlohmann::json& result);
    std::optional<std::string> any(const std::string& type);
    bool few(const std::string& type) const;
    void wrong(const std::string& what);

    World& world_;
    std::string name_;
    Dial dial_;
    std::shared_ptr<Link> link_;
    bool joined_ = false;
    bool editing_ = false;
    Duration every_{};
    std::string resume_token_;
    std::uint64_t seq_ = 0;
    int next_id_ = 1;
    std::map<int, Answer> asked_;
    Records records_;
    std::map<std::string, Subscription> subscriptions_;
    std::vector<Acknowledged> acknowledged_;
    std::string trouble_;
    bool acknowledges_ = true; ///< frames
    std::size_t edits_ = 0, deltas_ = 0, losses_ = 0, resumed_ = 0;
};

/// Returns the records of a snapshot, or of an answer of session.state.
Participant::Records records_of(const nlohmann::json& snapshot);

} // namespace wakesurf::simulation
