// The parts of every .glb file: metadata, arrays in its one buffer, one mesh (glTF 2.0, binary).
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <tiny_gltf.h>

#include <cstddef>
#include <string>
#include <vector>

namespace wakesurf::protocol::glb {

/// Returns the metadata as the extras of a scene.
tinygltf::Value::Object extras(const MeshMetadata& metadata);

/// Returns an accessor without a buffer view, as those of compressed data are.
tinygltf::Accessor accessor(std::size_t count, int type, int component);

/// Adds a part to the model and returns its index.
int add(tinygltf::Model& model, tinygltf::Accessor accessor);
int add_view(tinygltf::Model& model, std::size_t offset, std::size_t length, int target = 0);

void add_buffer(tinygltf::Model& model, std::vector<unsigned char> bytes);

/// Adds the file's one mesh, with a two-sided material.
void add_mesh(tinygltf::Model& model, tinygltf::Primitive primitive, int mode);

void set_bounds(tinygltf::Accessor& positions, const std::vector<core::Vec3f>& values);

/// Appends arrays to the file's one buffer.
class PlainArrays {
  public:
    explicit PlainArrays(tinygltf::Model& model) : model_(model) {}

    template <class T>
    int indices(const std::vector<T>& values) {
        return array(values, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                     values.size() * sizeof(T) / sizeof(std::uint32_t),
                     TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    }

    int vertices(const std::vector<core::Vec3f>& values) {
        return array(values, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT, values.size(),
                     TINYGLTF_TARGET_ARRAY_BUFFER);
    }

    int vertices(const std::vector<float>& values) {
        return array(values, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_FLOAT, values.size(),
                     TINYGLTF_TARGET_ARRAY_BUFFER);
    }

    /// Appends vectors as floats: glTF has the elements of an attribute begin at multiples of 4 bytes.
    template <class Whole>
    int vertices(const std::vector<Whole>& values) {
        return vertices(std::vector<float>(values.begin(), values.end()));
    }

    void finish() { add_buffer(model_, std::move(bytes_)); }

  private:
    template <class T>
    int
    array(const std::vector<T>& values, int type, int component, std::size_t count, int target) {
        auto out = accessor(count, type, component);
        const std::size_t first = bytes_.size();
        const auto* data = reinterpret_cast<const unsigned char*>(values.data());
        bytes_.insert(bytes_.end(), data, data + values.size() * sizeof(T));
        out.bufferView = add_view(model_, first, bytes_.size() - first, target);
        return add(model_, std::move(out));
    }

    tinygltf::Model& model_;
    std::vector<unsigned char> bytes_;
};

/// Returns the file. The mesh has the data's coordinates, and its node turns their z up: glTF's up is y. A model without
/// a mesh becomes a scene without one. Error: Corrupt.
core::Result<std::string>
file_of(tinygltf::Model& model, const std::string& version, tinygltf::Value::Object extras);

} // namespace wakesurf::protocol::glb
