// The parameters of setters, valid and invalid, in one table: the bombs, the bad input, and borderline cases.
// The outcome depends on the open datasets; that accepted records are kept never does.
#pragma once

#include <string>
#include <vector>

namespace wakesurf::tests {

struct RecordShape {
    std::string what;
    std::string method;
    std::string parameters;  ///< JSON text of its members but `session`, without braces
    bool always_bad = false; ///< refused with -32602 or -32700 whatever is open
};

inline std::string repeated(const std::string& item, std::size_t count) {
    std::string out = "[";
    for (std::size_t i = 0; i < count; ++i)
        out += (i == 0 ? "" : ",") + item;
    return out + "]";
}

inline std::vector<RecordShape> rake_shapes() {
    const auto line = [](const std::string& more) {
        return R"("kind":"line","points":[[0,0,0],[1,0,0]],)" + more;
    };
    const auto points = [](const std::string& kind, const std::string& places) {
        return R"("kind":")" + kind + R"(","seeds":8,"points":)" + places;
    };
    std::vector<RecordShape> out;
    const auto good = [&](std::string what, std::string parameters) {
        out.push_back({std::move(what), "rake.set", std::move(parameters), false});
    };
    const auto bad = [&](std::string what, std::string parameters) {
        out.push_back({std::move(what), "rake.set", std::move(parameters), true});
    };
    good("a plain line", line(R"("seeds":8)"));
    good("the most seeds", line(R"("seeds":4096)"));
    good("a name of signs", line(R"("seeds":2,"name":"\" \\ / \u00e9 \u2028 \ud83c\udf0a")"));
    good("a name that cannot be seen", line(R"("seeds":2,"name":"\u202e\u200b")"));
    good("a longest name", line("\"seeds\":2,\"name\":\"" + std::string(120, 'n') + "\""));
    good("a colour in capitals", line(R"("seeds":2,"colour":"#ABCDEF")"));
    good("odd numbers",
         points("line", "[[0.1,1e-300,-0.0],[0.30000000000000004,1e-7,123456789.125]]"));
    good("coordinates of 1e38", points("line", "[[1e38,0,0],[-1e38,0,0]]"));
    good("points 1e-300 apart", points("line", "[[0,0,0],[1e-300,0,0]]"));
    good("points 1e-320 apart", points("line", "[[1e-320,0,0],[0,1e-320,0]]"));
    good("neighbours an ulp apart", points("line", "[[1,0,0],[1.0000000000000002,0,0]]"));
    good("across a corner of the domain", points("line", "[[10,10.5,0],[10.5,10,0]]"));
    good(
        "a graze of a corner",
        points(
            "line",
            "[[9.999999999999998,10.000000000000002,0],[10.000000000000002,9.999999999999998,0]]"));
    good("partly outside", points("line", "[[0,0,0],[50,0,0]]"));
    good("far outside", points("line", "[[50,50,50],[51,50,50]]"));
    good("a polyline", points("polyline", "[[0,0,0],[1,0,0],[1,1,0]]"));
    good("the most points", points("polyline", [] {
             std::string all = "[";
             for (int i = 0; i < 1024; ++i)
                 all += (i == 0 ? "[" : ",[") + std::to_string(0.001 * i) + ",0,0]";
             return all + "]";
         }()));
    good("a circle", points("circle", "[[0,0,0],[1,0,0],[0,1,0]]"));
    good("a circle partly outside", points("circle", "[[9.5,0,0],[11,0,0],[9.5,1.5,0]]"));
    good("a cloud of points", points("points", "[[0,0,0],[1,1,1],[2,0,1]]"));
    bad("a rake of no length", points("line", "[[0,0,0],[0,0,0]]"));
    bad("a line of three points", points("line", "[[0,0,0],[1,0,0],[2,0,0]]"));
    bad("a line of one point", points("line", "[[0,0,0]]"));
    bad("no points", points("line", "[]"));
    bad("a polyline of 1,000 times one point", points("polyline", repeated("[1,1,1]", 1000)));
    bad("a polyline that stays", points("polyline", "[[0,0,0],[1,0,0],[1,0,0],[2,0,0]]"));
    bad("5,000 points", points("points", repeated("[0,1,2]", 5000)));
    bad("1,025 points", points("points", repeated("[0,1,2]", 1025)));
    bad("a circle of no radius", points("circle", "[[0,0,0],[0,0,0],[0,0,0]]"));
    bad("a circle on a line", points("circle", "[[0,0,0],[1,0,0],[2,0,0]]"));
    bad("a circle of two points", points("circle", "[[0,0,0],[1,0,0]]"));
    bad("points of points", points("line", "[[[0,0,0]],[[1,0,0]]]"));
    bad("coordinates of 1e300", points("line", "[[1e300,-1e300,1e300],[0,0,0]]"));
    bad("coordinates of 1e39", points("line", "[[1e39,0,0],[0,0,0]]"));
    bad("an unknown kind", points("spiral", "[[0,0,0],[1,0,0]]"));
    bad("10^9 seeds", line(R"("seeds":1000000000)"));
    bad("2^64 seeds", line(R"("seeds":18446744073709551616)"));
    bad("one seed", line(R"("seeds":1)"));
    bad("the fraction of a seed", line(R"("seeds":0.0000001)"));
    bad("NaN", line(R"("seeds":NaN)"));
    bad("1e999", points("line", "[[0,0,0],[1e999,0,0]]"));
    bad("no colour", line(R"("seeds":8,"colour":"red")"));
    bad("a NUL in a name", line(R"("seeds":8,"name":"a\u0000b")"));
    bad("a name too long", line("\"seeds\":8,\"name\":\"" + std::string(121, 'n') + "\""));
    return out;
}

/// Returns the shapes for an existing `rake`; the dataset is `lamb-oseen`.
inline std::vector<RecordShape> surface_shapes(const std::string& rake) {
    std::vector<RecordShape> out;
    const auto add = [&](std::string what, const std::string& more) {
        out.push_back({std::move(what), "surface.set",
                       R"("rake":")" + rake + R"(","dataset":"lamb-oseen",)" + more, false});
    };
    add("a stream surface", R"("kind":"stream","from":0,"to":0.1,"maxQuads":2000)");
    add("backward", R"("kind":"path","from":1,"to":0.9,"direction":"backward","maxQuads":2000)");
    add("a streak sheet",
        R"("kind":"streak","from":0,"to":0.1,"releaseUntil":0.05,"maxQuads":2000)");
    add("a streak released too long", R"("kind":"streak","from":0,"to":1,"releaseUntil":2)");
    add("a swept patch", R"("kind":"time","from":0,"to":0.1,"sweep":[0,0,0.5],"maxQuads":2000)");
    add("a sweep to nowhere", R"("kind":"time","from":0,"to":0.1,"sweep":[0,0,0])");
    add("between a rake and itself", R"("kind":"time","from":0,"to":1,"rake2":")" + rake + "\"");
    add("a least separation",
        R"("kind":"stream","from":0,"to":0.1,"separation":1e-300,"maxQuads":100)");
    add("a greatest separation",
        R"("kind":"stream","from":0,"to":0.1,"separation":1e300,"maxQuads":100)");
    add("fields twice",
        R"("kind":"stream","from":0,"to":0.1,"fields":["vorticity","vorticity"],"maxQuads":2000)");
    add("times of 1e30", R"("kind":"path","from":-1e30,"to":1e30,"maxQuads":100)");
    add("times of 1e35", R"("kind":"path","from":-1e35,"to":1e35,"maxQuads":100)");
    add("no time at all", R"("kind":"path","from":1,"to":1)");
    return out;
}

inline std::vector<RecordShape> other_shapes() {
    const std::string deep = [] {
        std::string text = "1";
        for (int level = 0; level < 27; ++level)
            text = R"({"a":)" + text + "}";
        return text;
    }();
    return {
        {"a slice", "slice.set",
         R"("dataset":"lamb-oseen","origin":[0,0.1,1e-7],"normal":[1e-300,0,0],"field":"vorticity_z")"},
        {"a slice of a field that is not there", "slice.set",
         R"("dataset":"lamb-oseen","origin":[0,0,0],"normal":[0,0,1],"field":"p\"")"},
        {"a slice beside the data", "slice.set",
         R"("dataset":"lamb-oseen","origin":[1e38,0,0],"normal":[1,0,0])"},
        {"a slice without a direction", "slice.set",
         R"("dataset":"lamb-oseen","origin":[0,0,0],"normal":[0,0,0])"},
        {"a slice at 1e39", "slice.set",
         R"("dataset":"lamb-oseen","origin":[1e39,0,0],"normal":[1,0,0])", true},
        {"lines", "lines.set",
         R"("dataset":"lamb-oseen","kind":"line","points":[[0.1,0,0],[1e-7,1,0]],"seeds":7,"low":-1,"high":2.5)"},
        {"lines from a sphere of 1e30", "lines.set",
         R"("dataset":"lamb-oseen","kind":"sphere","points":[[0,0,0]],"distance":1e30,"seeds":7)"},
        {"a million lines", "lines.set",
         R"("dataset":"lamb-oseen","kind":"line","points":[[0,0,0],[1,0,0]],"seeds":1000000)",
         true},
        {"lines off walls that are not there", "lines.set",
         R"("dataset":"lamb-oseen","kind":"walls","points":[],"distance":0.1,"seeds":7)"},
        {"a bookmark", "bookmark.set", R"("name":"here","view":{"camera":[1,2.5,-3e-7]})"},
        {"an empty view", "bookmark.set", R"("view":{})"},
        {"a deep view", "bookmark.set", R"("view":{"v":)" + deep + "}"},
        {"numbers in a view", "bookmark.set",
         R"("view":{"a":1e300,"b":-0.0,"c":18446744073709551615,"d":0.1})"},
        {"a longest view", "bookmark.set", R"("view":{"v":")" + std::string(4085, 'v') + "\"}"},
        {"a view too long", "bookmark.set", R"("view":{"v":")" + std::string(5000, 'v') + "\"}",
         true},
        {"a bookmark's time", "bookmark.set", R"("view":{},"time":3.4e38)"},
        {"a note", "annotation.set", R"("text":"a\n\tb \u2028 \ud83c\udf0a","position":[1,2,3])"},
        {"an empty note", "annotation.set", R"("text":"","position":[0,0,0])"},
        {"a longest note", "annotation.set",
         "\"position\":[0,0,0],\"text\":\"" + std::string(4096, 'n') + "\""},
        {"a note at 1e38", "annotation.set", R"("text":"far","position":[1e38,-1e38,0])"},
        {"a note at 1e39", "annotation.set", R"("text":"far","position":[1e39,0,0])", true},
        {"a note with a bell", "annotation.set", R"("text":"\u0007","position":[0,0,0])", true},
        {"a time", "time.set", R"("time":1e30)"},
        {"a time too far", "time.set", R"("time":1e31)", true},
        {"a play of all surfaces", "time.play", ""},
        {"a play", "time.play", R"("from":0,"to":1e-300,"speed":1e-9)"},
        {"a loop", "time.play", R"("from":-1e30,"to":1e30,"speed":1000000,"loop":true)"},
        {"a pause", "time.pause", ""},
    };
}

} // namespace wakesurf::tests
