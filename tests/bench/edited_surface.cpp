#include "tests/bench/edited_surface.hpp"

#include "protocol/wire/mesh_frame.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace wakesurf::bench {

using nlohmann::json;

EditedSurface::EditedSurface(const ServerAddress& address, double quads, int seeds)
    : client_(address), seeds_(seeds) {
    const std::string id = ready_dataset();
    const json info = client_.call("dataset.describe", {{"dataset", id}});
    for (int axis = 0; axis < 3; ++axis) {
        low_[axis] = info["bounds"][static_cast<std::size_t>(2 * axis)];
        size_[axis] =
            info["bounds"][static_cast<std::size_t>(2 * axis + 1)].get<double>() - low_[axis];
    }
    session_ = client_.call("session.create", {{"name", "bench"}})["session"];
    client_.call("session.join", {{"session", session_}, {"name", "bench"}});
    rake_ = client_.call("rake.set", rake())["rake"];
    const double from = info["times"][0];
    double separation = std::max({size_.x, size_.y, size_.z}) / 200.0;
    for (int i = 0; i < 6; ++i) {
        json surface{{"rake", rake_},          {"kind", "stream"},  {"dataset", id},
                     {"from", from},           {"to", from + 20.0}, {"separation", separation},
                     {"fields", json::array()}};
        if (!surface_.empty())
            surface["surface"] = surface_;
        surface_ = client_.call("surface.set", surface)["surface"];
        quads_ = complete()["quads"];
        separation *= std::sqrt(quads_ / quads);
    }
    client_.call("surface.subscribe", {{"surface", surface_}});
}

/// The server's only dataset, once its import is done.
std::string EditedSurface::ready_dataset() {
    for (int i = 0; i < 3000; ++i) {
        const json entry = client_.call("dataset.list", json::object())["datasets"][0];
        if (entry["state"] == "ready")
            return entry["dataset"];
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    throw std::runtime_error("the dataset was not imported within a minute");
}

json EditedSurface::rake() const {
    const double y = 0.40 + 0.02 * std::sin(phase_);
    const auto point = [&](double z) {
        const core::Vec3 p = low_ + size_ * core::Vec3(0.245, y, z);
        return json{p.x, p.y, p.z};
    };
    json record{{"kind", "line"}, {"points", {point(0.05), point(0.95)}}, {"seeds", seeds_}};
    if (!rake_.empty())
        record["rake"] = rake_;
    return record;
}

json EditedSurface::next_edit() {
    phase_ += 0.1;
    return rake();
}

json EditedSurface::complete() {
    return client_.call("surface.wait", {{"surface", surface_}, {"timeoutMs", 60'000}});
}

std::uint32_t EditedSurface::until_frame_after(std::uint32_t epoch) {
    for (;;) {
        const protocol::Bytes bytes = client_.next_frame();
        if (const auto frame = protocol::read_frame(bytes); frame && frame->header.epoch > epoch)
            return frame->header.epoch;
    }
}

} // namespace wakesurf::bench
