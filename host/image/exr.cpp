#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "image/mark.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

/// A file in memory. OpenEXR moves back in it to fill in its table of line offsets.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}

  void write(const char bytes[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + position_, bytes, static_cast<std::size_t>(count));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

/// The attribute of the mark.
constexpr const char* kMark = "aerostat";

/// A file in memory that is read.
class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const std::uint8_t> bytes)
      : Imf::IStream("memory"), bytes_(bytes) {}

  bool read(char to[], int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (wanted > bytes_.size() - std::min<std::size_t>(position_, bytes_.size())) {
      throw Error(ErrorKind::bad_data, "the file ends too early");
    }
    std::memcpy(to, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::uint64_t position_ = 0;
};

/// Decodes all pixels of a file, a row at a time, and keeps none.
void decode_rows(Imf::InputFile& file) {
  const Imath::Box2i& data = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(data.max.x - data.min.x + 1);
  std::vector<std::vector<std::uint32_t>> rows;
  Imf::FrameBuffer frame;
  const Imf::ChannelList& channels = file.header().channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    rows.emplace_back(width);
    // All rows go to the same memory: the stride from row to row is 0.
    constexpr std::size_t kStride = sizeof(std::uint32_t);
    char* const first = reinterpret_cast<char*>(rows.back().data());
    frame.insert(channel.name(),
                 Imf::Slice(channel.channel().type,
                            first - static_cast<std::ptrdiff_t>(kStride) * data.min.x, kStride, 0));
  }
  for (int y = data.min.y; y <= data.max.y; ++y) {
    file.setFrameBuffer(frame);
    file.readPixels(y);
  }
}

/// Declares the channels and tells where their values lie.
class Layers {
 public:
  Layers(const Film& film, const std::string& mark)
      : data_({film.first.x, film.first.y},
              {film.first.x + film.width - 1, film.first.y + film.height - 1}),
        header_(display_of(film), data_) {
    header_.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header_, Imf::Chromaticities{});  // Rec. 709
    header_.insert("software", Imf::StringAttribute("aerostat"));
    if (!mark.empty()) header_.insert(kMark, Imf::StringAttribute(mark));
  }

  void add(const char* name, Imf::PixelType type, const void* first, std::size_t stride) {
    header_.channels().insert(name, Imf::Channel(type));
    frame_.insert(name, Imf::Slice::Make(type, first, data_, stride));
  }

  void add_vector(const char* x, const char* y, const char* z, const Array<vec3>& values) {
    add(x, Imf::FLOAT, &values[0].x, sizeof(vec3));
    add(y, Imf::FLOAT, &values[0].y, sizeof(vec3));
    add(z, Imf::FLOAT, &values[0].z, sizeof(vec3));
  }

  const Imf::Header& header() const { return header_; }
  const Imf::FrameBuffer& frame() const { return frame_; }

 private:
  static Imath::Box2i display_of(const Film& film) {
    const glm::ivec2 size =
        film.whole == glm::ivec2(0) ? glm::ivec2(film.width, film.height) : film.whole;
    return {{0, 0}, {size.x - 1, size.y - 1}};
  }

  Imath::Box2i data_;
  Imf::Header header_;
  Imf::FrameBuffer frame_;
};

void require_layer(std::size_t size, std::size_t pixels, bool optional) {
  if (size != pixels && !(optional && size == 0)) {
    throw Error(ErrorKind::internal, fmt::format("encoding an EXR: a layer has {} values for {} "
                                                 "pixels",
                                                 size, pixels));
  }
}

void require_layers(const Film& film) {
  if (film.width <= 0 || film.height <= 0) {
    throw Error(ErrorKind::internal,
                fmt::format("encoding an EXR of {} x {} pixels", film.width, film.height));
  }
  const std::size_t pixels =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  require_layer(film.radiance.size(), pixels, false);
  require_layer(film.alpha.size(), pixels, true);
  require_layer(film.distance_m.size(), pixels, true);
  require_layer(film.albedo.size(), pixels, true);
  require_layer(film.normal_ws.size(), pixels, true);
  require_layer(film.object_id.size(), pixels, true);
  require_layer(film.samples.size(), pixels, true);
}

Layers layers_of(const Film& film, const std::string& mark) {
  Layers layers(film, mark);
  layers.add_vector("R", "G", "B", film.radiance);
  if (!film.alpha.empty()) layers.add("A", Imf::FLOAT, film.alpha.data(), sizeof(float));
  if (!film.distance_m.empty()) layers.add("Z", Imf::FLOAT, film.distance_m.data(), sizeof(float));
  if (!film.albedo.empty()) layers.add_vector("albedo.R", "albedo.G", "albedo.B", film.albedo);
  if (!film.normal_ws.empty()) layers.add_vector("N.X", "N.Y", "N.Z", film.normal_ws);
  if (!film.object_id.empty()) {
    layers.add("id", Imf::UINT, film.object_id.data(), sizeof(std::uint32_t));
  }
  if (!film.samples.empty()) {
    layers.add("samples", Imf::UINT, film.samples.data(), sizeof(std::uint32_t));
  }
  return layers;
}

}  // namespace

std::vector<std::uint8_t> encode_exr(const Film& film, const std::string& mark) {
  require_layers(film);
  MemoryStream stream;
  try {
    const Layers layers = layers_of(film, mark);
    Imf::OutputFile file(stream, layers.header());
    file.setFrameBuffer(layers.frame());
    file.writePixels(film.height);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorKind::internal, fmt::format("encoding an EXR of {} x {} pixels failed: {}",
                                                 film.width, film.height, error.what()));
  }
  return stream.take();
}

MarkedFile mark_of_exr(std::span<const std::uint8_t> exr) {
  MarkedFile marked;
  try {
    MemoryInput stream(exr);
    Imf::InputFile file(stream);
    const auto* const mark = file.header().findTypedAttribute<Imf::StringAttribute>(kMark);
    if (mark != nullptr) marked.mark = mark->value();
    decode_rows(file);
    marked.is_whole = true;
  } catch (const std::exception&) {
    // OpenEXR says by an exception that a file is damaged, and the caller needs no more than that.
    marked.is_whole = false;
  }
  return marked;
}

}  // namespace aerostat::image
