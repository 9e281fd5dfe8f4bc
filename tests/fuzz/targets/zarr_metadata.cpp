// The metadata of a Zarr's array, of both versions: what is read has chunks whose numbers can be counted.
#include "server/remote/zarr/zarr_metadata.hpp"

#include "tests/fuzz/targets/all.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::fuzz {

namespace {

void check(const core::Result<server::ZarrArray>& array) {
    if (!array)
        return;
    demand(array->chunks.size() == array->shape.size(), "as many axes of chunks as of the array");
    demand(array->chunk_numbers() > 0 && array->chunk_bytes() <= 0x7fffffff,
           "a chunk has numbers, and no more than 2 GiB");
    for (std::size_t axis = 0; axis < array->shape.size(); ++axis)
        demand(array->chunks_along(axis) > 0, "there are chunks along each axis");
    for (const std::string& name : array->dimensions)
        demand(server::is_plain_name(name), "names lead nowhere");
}

void run(Input input) {
    const auto value = server::parse_zarr_json(text_of(input));
    if (!value)
        return;
    check(server::parse_zarr_2("u", *value, *value));
    check(server::parse_zarr_3("u", *value));
}

std::vector<std::string> seeds() {
    return {
        R"({"shape": [5, 20, 30, 40], "chunks": [1, 8, 8, 8], "dtype": "<f4", "order": "C", "filters": null, "compressor": {"id": "blosc"},
                "fill_value": "NaN", "dimension_separator": "/", "_ARRAY_DIMENSIONS": ["time", "z", "y", "x"], "units": "m s-1"})",
        R"({"shape": [20, 30, 40], "data_type": "float64", "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [8, 8, 8]}},
                "chunk_key_encoding": {"name": "default", "configuration": {"separator": "/"}}, "fill_value": "0x7ff8000000000000",
                "codecs": [{"name": "bytes", "configuration": {"endian": "big"}}, {"name": "gzip"}, "crc32c"],
                "dimension_names": ["z", "y", "x"], "attributes": {"scale_factor": 2, "_FillValue": -9}})",
        "{}"};
}

} // namespace

const Target zarr_metadata_target{"zarr_metadata", run, seeds, true};

} // namespace wakesurf::fuzz
