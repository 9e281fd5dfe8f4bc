#include "server/app/surface_picture.hpp"

#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/names.hpp"
#include "server/app/python_program.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace wakesurf::server {

namespace {

nlohmann::json rake_json(const core::Rake& rake) {
    return {{"kind", protocol::name(rake.kind)},
            {"points", protocol::points_json(rake.points)},
            {"seeds", rake.seeds}};
}

/// Returns the options of the server that draws it.
std::vector<std::string> server_words(const SurfaceOptions& options) {
    std::vector<std::string> words = arguments_of(options.taken);
    if (!options.store.empty())
        words.push_back("--store=" + options.store);
    if (options.memory > 0)
        words.push_back("--memory=" + std::to_string(options.memory));
    if (options.threads > 0)
        words.push_back("--threads=" + std::to_string(options.threads));
    return words;
}

} // namespace

int draw_surface(const SurfaceOptions& options, const SurfaceRequest& request) {
    nlohmann::json job{{"size", options.size},
                       {"seeds", options.seeds},
                       {"surface", nlohmann::json::parse(request.asked)}};
    job["surface"]["maxQuads"] = options.max_quads;
    job["surface"]["fields"] = options.fields;
    job["points"] = !options.lines.empty();
    if (!options.rake.empty())
        job["rake"] = rake_json(request.rake);
    if (request.parameters.rake2)
        job["rake2"] = rake_json(*request.parameters.rake2);
    // Paths are separate words: they need not be UTF-8, but JSON is.
    std::vector<std::string> words{
        job.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), options.dataset,
        options.output};
    for (const std::string& word : server_words(options))
        words.push_back(word);
    return become_python("draw", words);
}

} // namespace wakesurf::server
