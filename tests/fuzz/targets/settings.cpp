// What edits send: the parameters of a call, read as every kind of setting and as presence.
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/generated/annotation.hpp"
#include "protocol/api/generated/bookmark.hpp"
#include "protocol/api/generated/dataset.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/lines.hpp"
#include "protocol/api/generated/presence.hpp"
#include "protocol/api/generated/rake.hpp"
#include "protocol/api/generated/session.hpp"
#include "protocol/api/generated/slice.hpp"
#include "protocol/api/generated/subscription.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/api/generated/time.hpp"
#include "tests/fuzz/targets/all.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace wakesurf::fuzz {

namespace {

bool finite(const core::Vec3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

void run(Input input) {
    const auto object = protocol::parse_json(text_of(input), {});
    if (!object || !object->is_object())
        return;
    namespace limits = protocol::limits;
    if (const auto rake = protocol::parse_call<protocol::RakeSetting>(*object)) {
        demand(std::all_of(rake->shape.points.begin(), rake->shape.points.end(), finite),
               "the points of a rake are finite");
        demand(rake->shape.points.size() <= limits::rake_points &&
                   rake->shape.seeds >= limits::seeds_least &&
                   rake->shape.seeds <= limits::seeds_most,
               "a rake is within its limits");
    }
    if (const auto surface = protocol::parse_call<protocol::SurfaceSetting>(*object))
        demand(std::isfinite(surface->parameters.separation) &&
                   std::isfinite(surface->from.value_or(0.0)) &&
                   std::isfinite(surface->parameters.to),
               "the numbers of a surface are finite");
    protocol::parse_call<protocol::SliceSetting>(*object);
    protocol::parse_call<protocol::LinesSetting>(*object);
    protocol::parse_call<protocol::BookmarkSetting>(*object);
    protocol::parse_call<protocol::AnnotationSetting>(*object);
    protocol::parse_call<protocol::PlaySetting>(*object);
    protocol::parse_call<protocol::TimeSet>(*object);
    protocol::parse_call<protocol::PresenceUpdate>(*object);
    protocol::parse_call<protocol::SurfaceSubscribe>(*object);
    protocol::parse_call<protocol::SessionJoin>(*object);
    protocol::parse_call<protocol::DatasetOpen>(*object);
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
