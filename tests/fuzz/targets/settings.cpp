// What edits send: the parameters of a call, read as every kind of setting and as presence.
#include "protocol/api/json_text.hpp"
#include "protocol/api/messages_annotation.hpp"
#include "protocol/api/messages_bookmark.hpp"
#include "protocol/api/messages_presence.hpp"
#include "protocol/api/messages_rake.hpp"
#include "protocol/api/messages_surface.hpp"
#include "protocol/api/messages_time.hpp"
#include "tests/fuzz/targets/all.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace wakesurf::fuzz {

namespace {

bool finite(const core::Vec3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

template <class Read>
auto read_as(const nlohmann::json& object, Read read) {
    protocol::CheckedJson in(object);
    auto value = read(in);
    return in.verdict() ? std::optional(std::move(value)) : std::nullopt;
}

void run(Input input) {
    const auto object = protocol::parse_json(text_of(input), {});
    if (!object || !object->is_object())
        return;
    const protocol::RakeLimits rakes;
    if (const auto rake =
            read_as(*object, [&](auto& in) { return read_rake_setting(in, rakes); })) {
        demand(std::all_of(rake->shape.points.begin(), rake->shape.points.end(), finite),
               "the points of a rake are finite");
        demand(rake->shape.points.size() <= rakes.points &&
                   rake->shape.seeds >= rakes.seeds_least && rake->shape.seeds <= rakes.seeds_most,
               "a rake is within its limits");
    }
    if (const auto surface =
            read_as(*object, [](auto& in) { return protocol::read_surface_setting(in, {}); }))
        demand(std::isfinite(surface->parameters.separation) &&
                   std::isfinite(surface->parameters.from) && std::isfinite(surface->parameters.to),
               "the numbers of a surface are finite");
    read_as(*object, [](auto& in) { return protocol::read_bookmark_setting(in, {}); });
    read_as(*object, [](auto& in) { return protocol::read_annotation_setting(in, {}); });
    read_as(*object, [](auto& in) { return protocol::read_play_setting(in, 1e6); });
    read_as(*object, [&](auto& in) { return protocol::read_clock_time(in, *object); });
    read_as(*object, [&](auto& in) { return protocol::read_presence(in, *object, 64); });
}

std::vector<std::string> seeds() {
    return {
        R"({"kind":"line","points":[[0,0,0],[1,0,0]],"seeds":32,"name":"a","dragging":true,"ifRev":3})",
        R"({"rake":"r1","kind":"polyline","points":[[0,0,0],[1,0,0],[1,1,0]],"colour":"#12ab9f"})",
        R"({"kind":"circle","points":[[0,0,0],[1,0,0],[0,1,0]],"seeds":4096,"force":true})",
        R"({"rake":"r1","kind":"streak","dataset":"d","from":0,"to":4.5,"separation":0.1,"fields":["p","q"],"releaseUntil":2})",
        R"({"rake":"r1","rake2":"r2","kind":"time","dataset":"d","direction":"backward","accuracy":"exact","maxQuads":4000000})",
        R"({"rake":"r1","kind":"time","dataset":"d","sweep":[0,0,1],"angle":15,"merge":false})",
        R"({"name":"view","view":{"camera":[1,2,3]},"text":"note","point":[0,1,2]})",
        R"({"speed":2,"loop":true,"from":0,"to":1,"time":0.5})",
        R"({"pointer":[0,0,0],"camera":{"position":[0,0,1],"target":[0,0,0],"up":[0,1,0],"fov":45},"dragging":{"rake":"r1","points":[[0,0,0]]},"selected":"s1"})",
    };
}

} // namespace

const Target settings_target{"settings", run, seeds, true};

} // namespace wakesurf::fuzz
