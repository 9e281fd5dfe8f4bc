#include "protocol/draco_points.hpp"

#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>
#include <draco/point_cloud/point_cloud.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <string>
#include <type_traits>

namespace wakesurf::protocol {

namespace {

using core::Error;

constexpr int speed =
    5; ///< measured: other speeds change sizes by less than 1 %, times by less than 10 %

tl::unexpected<Error> corrupt(const std::string& message) {
    return core::fail(Error::Code::Corrupt, message, "subscribe to the surface again");
}

template <class T>
int add_attribute(draco::PointCloud& cloud, std::span<const T> values, draco::DataType type) {
    constexpr auto component_bytes = static_cast<std::int64_t>(
        std::is_same_v<T, LatticePoint> ? sizeof(std::int32_t) : sizeof(T));
    constexpr auto components = static_cast<std::int64_t>(sizeof(T)) / component_bytes;
    draco::GeometryAttribute description;
    description.Init(draco::GeometryAttribute::GENERIC, nullptr,
                     static_cast<std::uint8_t>(components), type, false,
                     components * component_bytes, 0);
    const int id = cloud.AddAttribute(
        description, true, static_cast<draco::AttributeValueIndex::ValueType>(values.size()));
    std::memcpy(cloud.attribute(id)->buffer()->data(), values.data(), values.size_bytes());
    return id;
}

/// All that Draco 2.3 says before the entropy-coded values of a cloud written by encode_points.
Bytes expected_start(std::uint32_t points, std::size_t byte_planes) {
    Bytes bytes;
    for (const char letter : {'D', 'R', 'A', 'C', 'O'})
        append(bytes, letter);
    for (const int field : {2, 3, +draco::POINT_CLOUD, +draco::POINT_CLOUD_SEQUENTIAL_ENCODING})
        append(bytes, static_cast<std::uint8_t>(field));
    append(bytes, std::uint16_t{0}); // flags: no metadata
    append(bytes, points);
    append(bytes, std::uint8_t{1}); // one group of attributes
    append(bytes, static_cast<std::uint8_t>(byte_planes + 1));
    for (std::size_t i = 0; i <= byte_planes; ++i) {
        append(bytes, static_cast<std::uint8_t>(draco::GeometryAttribute::GENERIC));
        append(bytes, static_cast<std::uint8_t>(i == 0 ? draco::DT_INT32 : draco::DT_UINT8));
        append(bytes, static_cast<std::uint8_t>(i == 0 ? 3 : 1));
        append(bytes, std::uint8_t{0}); // not normalised
        append(bytes, static_cast<std::uint8_t>(i));
    }
    for (std::size_t i = 0; i <= byte_planes; ++i)
        append(bytes, static_cast<std::uint8_t>(draco::SEQUENTIAL_ATTRIBUTE_ENCODER_INTEGER));
    return bytes;
}

/// Draco predicts each difference from the one before, so that a straight column costs next to nothing.
std::vector<LatticePoint> differences(std::span<const LatticePoint> positions) {
    std::vector<LatticePoint> result(positions.begin(), positions.end());
    for (std::size_t i = result.size(); i-- > 1;)
        for (std::size_t axis = 0; axis < 3; ++axis)
            result[i][axis] -= positions[i - 1][axis];
    return result;
}

/// The inverse; sums wrap, because damaged bytes may hold any differences.
void sum_up(std::span<LatticePoint> positions) {
    for (std::size_t i = 1; i < positions.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            positions[i][axis] =
                static_cast<std::int32_t>(static_cast<std::uint32_t>(positions[i][axis]) +
                                          static_cast<std::uint32_t>(positions[i - 1][axis]));
}

/// The low or the high byte of each difference of consecutive codes. Whole differences would be symbols of up to 17
/// bits, whose tables cost Draco milliseconds; bytes cost it none.
std::vector<std::uint8_t> byte_plane(std::span<const std::uint16_t> codes, int shift) {
    std::vector<std::uint8_t> plane;
    plane.reserve(codes.size());
    std::uint16_t before = 0;
    for (const std::uint16_t code : codes) {
        plane.push_back(static_cast<std::uint8_t>((code - before) >> shift));
        before = code;
    }
    return plane;
}

void join_planes(std::span<const std::uint8_t> low,
                 std::span<const std::uint8_t> high,
                 std::span<std::uint16_t> codes) {
    std::uint16_t code = 0;
    for (std::size_t i = 0; i < codes.size(); ++i)
        codes[i] = code = static_cast<std::uint16_t>(code + low[i] + 256 * high[i]);
}

template <class T>
bool copy_attribute(const draco::PointCloud& cloud, int id, std::span<T> values) {
    const draco::PointAttribute& attribute = *cloud.attribute(id);
    if (!attribute.is_mapping_identity() || attribute.size() != values.size() ||
        attribute.byte_stride() != static_cast<std::int64_t>(sizeof(T)) ||
        attribute.buffer()->data_size() < values.size_bytes())
        return false;
    std::memcpy(values.data(), attribute.buffer()->data(), values.size_bytes());
    return true;
}

} // namespace

core::Result<Bytes> encode_points(std::span<const LatticePoint> positions,
                                  std::span<const std::span<const std::uint16_t>> attributes) try {
    draco::PointCloud cloud;
    cloud.set_num_points(static_cast<draco::PointIndex::ValueType>(positions.size()));
    add_attribute<LatticePoint>(cloud, differences(positions), draco::DT_INT32);
    for (const auto codes : attributes)
        for (const int shift : {0, 8})
            add_attribute<std::uint8_t>(cloud, byte_plane(codes, shift), draco::DT_UINT8);
    draco::ExpertEncoder encoder(cloud);
    encoder.SetEncodingMethod(draco::POINT_CLOUD_SEQUENTIAL_ENCODING);
    encoder.SetSpeedOptions(speed, speed);
    for (int id = 0; id < cloud.num_attributes(); ++id) {
        // Without a prediction an outlier sizes a histogram of gigabytes.
        const draco::Status status =
            encoder.SetAttributePredictionScheme(id, draco::PREDICTION_DIFFERENCE);
        if (!status.ok())
            return corrupt(std::string("Draco refused its prediction: ") + status.error_msg());
    }
    draco::EncoderBuffer out;
    if (const draco::Status status = encoder.EncodeToBuffer(&out); !status.ok())
        return corrupt(std::string("Draco did not encode the points: ") + status.error_msg());
    const auto* raw = reinterpret_cast<const std::byte*>(out.data());
    return Bytes(raw, raw + out.size());

} catch (const std::bad_alloc&) {

    return core::fail(Error::Code::OverLimit,
                      "not enough memory to encode " + std::to_string(positions.size()) + " points",
                      "ask for fewer quads");

} catch (const std::exception& thrown) {

    return corrupt(std::string("Draco failed on the points: ") + thrown.what());
}

core::Result<void> decode_points(std::span<const std::byte> draco_bytes,
                                 std::span<LatticePoint> positions,
                                 std::span<const std::span<std::uint16_t>> attributes) try {
    const Bytes start =
        expected_start(static_cast<std::uint32_t>(positions.size()), 2 * attributes.size());
    if (draco_bytes.size() < start.size() ||
        !std::ranges::equal(start, draco_bytes.first(start.size())))
        return corrupt("the Draco block of a mesh frame is not what its header announces");
    draco::DecoderBuffer in;
    in.Init(reinterpret_cast<const char*>(draco_bytes.data()), draco_bytes.size());
    draco::Decoder decoder;
    const auto decoded = decoder.DecodePointCloudFromBuffer(&in);
    if (!decoded.ok())
        return corrupt(std::string("Draco did not decode a mesh frame: ") +
                       decoded.status().error_msg());
    const draco::PointCloud& cloud = *decoded.value();
    bool whole = cloud.num_attributes() == 2 * static_cast<int>(attributes.size()) + 1 &&
                 copy_attribute(cloud, 0, positions);
    std::vector<std::uint8_t> low(positions.size());
    std::vector<std::uint8_t> high(positions.size());
    for (int i = 0; whole && i < static_cast<int>(attributes.size()); ++i) {
        whole = copy_attribute<std::uint8_t>(cloud, 2 * i + 1, low) &&
                copy_attribute<std::uint8_t>(cloud, 2 * i + 2, high);
        join_planes(low, high, attributes[static_cast<std::size_t>(i)]);
    }
    if (!whole)
        return corrupt("a mesh frame decoded to other points than it announced");
    sum_up(positions);
    return {};

} catch (const std::exception& thrown) {

    return corrupt(std::string("Draco failed on a mesh frame: ") + thrown.what());
}

} // namespace wakesurf::protocol
