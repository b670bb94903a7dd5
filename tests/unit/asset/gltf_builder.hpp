#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

namespace aerostat::asset {

/// Puts small glTF files together. Each list of numbers gets a buffer view and an accessor of its
/// own, which are counted from 0.
class GltfBuilder {
 public:
  /// Adds numbers of a type and an accessor over them. `more` are further members, each behind a
  /// comma.
  template <class Number>
  GltfBuilder& add(int code, const std::string& type, std::size_t count,
                   std::initializer_list<double> numbers, const std::string& more = {}) {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    const std::size_t offset = bytes_.size();
    for (const double number : numbers) {
      const auto stored = static_cast<Number>(number);
      bytes_.append(reinterpret_cast<const char*>(&stored), sizeof(Number));
    }
    views_.push_back(R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
                     std::to_string(bytes_.size() - offset) + "}");
    accessors_.push_back(R"({"bufferView":)" + std::to_string(views_.size() - 1) +
                         R"(,"componentType":)" + std::to_string(code) + R"(,"type":")" + type +
                         R"(","count":)" + std::to_string(count) + more + "}");
    return *this;
  }

  GltfBuilder& floats(const std::string& type, std::size_t count,
                      std::initializer_list<double> numbers) {
    return add<float>(5126, type, count, numbers);
  }

  GltfBuilder& accessor(const std::string& json) {
    accessors_.push_back(json);
    return *this;
  }

  /// Adds a view over bytes.
  GltfBuilder& view(const std::string& bytes, const std::string& more = {}) {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    views_.push_back(R"({"buffer":0,"byteOffset":)" + std::to_string(bytes_.size()) +
                     R"(,"byteLength":)" + std::to_string(bytes.size()) + more + "}");
    bytes_ += bytes;
    return *this;
  }

  /// The positions of a square of four corners, accessor 0: as a strip, a fan turned over or two
  /// triangles by indices.
  GltfBuilder& square() { return floats("VEC3", 4, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}); }

  /// Returns a .gltf. `rest` are the members besides buffers, views, accessors and asset.
  std::string text(const std::string& rest) const {
    return document(rest,
                    R"("uri":"data:application/octet-stream;base64,)" + base64(bytes_) + R"(",)");
  }

  /// Returns a .glb.
  std::string binary(const std::string& rest) const {
    std::string json = document(rest, ""), bytes = bytes_;
    while (json.size() % 4 != 0) json += ' ';
    while (bytes.size() % 4 != 0) bytes += '\0';
    const std::string chunks = chunk(0x4e4f534a, json) + chunk(0x004e4942, bytes);
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
  }

  const std::string& bytes() const { return bytes_; }

  /// Returns a .gltf whose buffer is at a URI.
  std::string with_uri(const std::string& rest, const std::string& uri) const {
    return document(rest, R"("uri":")" + uri + R"(",)");
  }

  static std::string base64(const std::string& bytes) {
    static constexpr char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63u];
      }
    }
    return text;
  }

  static std::string word(std::size_t number) {
    const auto stored = static_cast<std::uint32_t>(number);
    return {reinterpret_cast<const char*>(&stored), 4};
  }

  static std::string chunk(std::size_t type, const std::string& bytes) {
    return word(bytes.size()) + word(type) + bytes;
  }

 private:
  static std::string joined(const std::vector<std::string>& parts) {
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : ",") + part;
    return "[" + all + "]";
  }

  std::string document(const std::string& rest, const std::string& uri) const {
    std::string text = R"({"asset":{"version":"2.0"},"buffers":[{)" + uri + R"("byteLength":)" +
                       std::to_string(bytes_.size()) + "}]";
    text += R"(,"bufferViews":)" + joined(views_) + R"(,"accessors":)" + joined(accessors_);
    return text + (rest.empty() ? "" : "," + rest) + "}";
  }

  std::string bytes_;
  std::vector<std::string> views_, accessors_;
};

/// The members of a document with one node and one mesh, whose only primitive is `primitive`.
inline std::string one_mesh(const std::string& primitive, const std::string& node = {}) {
  return R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + node +
         R"(}],"meshes":[{"primitives":[{)" + primitive + "}]}]";
}

}  // namespace aerostat::asset
