#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "image/bands.hpp"
#include "image/exr_layers.hpp"
#include "image/exr_streams.hpp"
#include "image/write.hpp"

namespace aerostat::image {

namespace {

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

Imath::Box2i display_of(const Film& film) {
  const glm::ivec2 size =
      film.whole == glm::ivec2(0) ? glm::ivec2(film.width, film.height) : film.whole;
  return {{0, 0}, {size.x - 1, size.y - 1}};
}

/// Returns the header of a file with `rows` rows from the first one of a film on.
Imf::Header header_of(const Film& film, int rows) {
  const Imath::Box2i data({film.first.x, film.first.y},
                          {film.first.x + film.width - 1, film.first.y + rows - 1});
  Imf::Header header(display_of(film), data);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities{});  // Rec. 709
  header.insert("software", Imf::StringAttribute("aerostat"));
  each_channel(film, [&](const char* name, Imf::PixelType type, const void*, std::size_t) {
    header.channels().insert(name, Imf::Channel(type));
  });
  return header;
}

/// Runs a part of the encoding, and turns what OpenEXR throws into an Error.
template <typename Step>
void encoding(int width, int height, const Step& step) {
  try {
    step();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorKind::internal, fmt::format("encoding an EXR of {} x {} pixels failed: {}",
                                                 width, height, error.what()));
  }
}

/// A file that receives its rows from the top to the bottom.
class RowsFile {
 public:
  explicit RowsFile(const Imf::Header& header)
      : header_(header), next_row_(header.dataWindow().min.y) {
    encoding(columns(), rows(), [&] { file_.emplace(stream_, header_); });
  }

  void add(const Film& film) {
    require_layers(film);
    const Imath::Box2i& window = header_.dataWindow();
    if (film.first != glm::ivec2(window.min.x, next_row_) || film.width != columns() ||
        film.height > window.max.y + 1 - next_row_ ||
        !(header_of(film, film.height).channels() == header_.channels())) {
      throw Error(ErrorKind::internal,
                  fmt::format("encoding an EXR: {} rows from row {} on do not fit behind row {}",
                              film.height, film.first.y, next_row_ - 1));
    }
    encoding(film.width, film.height, [&] {
      file_->setFrameBuffer(frame_of(film));
      file_->writePixels(film.height);
    });
    next_row_ += film.height;
  }

  std::vector<std::uint8_t> take() {
    if (next_row_ != header_.dataWindow().max.y + 1) {
      throw Error(ErrorKind::internal,
                  fmt::format("encoding an EXR: the rows from {} on are missing", next_row_));
    }
    file_.reset();  // writes the table of line offsets
    return stream_.take();
  }

 private:
  int columns() const { return header_.dataWindow().max.x - header_.dataWindow().min.x + 1; }
  int rows() const { return header_.dataWindow().max.y - header_.dataWindow().min.y + 1; }

  Imf::Header header_;
  int next_row_;
  ExrOutput stream_;
  std::optional<Imf::OutputFile> file_;
};

std::vector<std::uint8_t> encode(const Film& film, const Imf::Header& header) {
  RowsFile file(header);
  file.add(film);
  return file.take();
}

void insert_mark(const std::string& mark, Imf::Header& header) {
  if (!mark.empty()) header.insert(kExrMark, Imf::StringAttribute(mark));
}

}  // namespace

std::vector<std::uint8_t> encode_exr(const Film& film, const std::string& mark) {
  require_layers(film);
  Imf::Header header = header_of(film, film.height);
  insert_mark(mark, header);
  return encode(film, header);
}

std::vector<std::uint8_t> encode_band(const Film& film, const std::string& mark,
                                      const Development& development) {
  require_layers(film);
  Imf::Header header = header_of(film, film.height);
  insert_mark(mark, header);
  Imath::M33d white_balance;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      white_balance[column][row] = development.white_balance[column][row];
    }
  }
  header.insert(kExrExposure, Imf::DoubleAttribute(development.exposure_ev));
  header.insert(kExrWhiteBalance, Imf::M33dAttribute(white_balance));
  header.insert(kExrVignette, Imf::DoubleAttribute(development.vignette));
  header.insert(kExrGlare, Imf::DoubleAttribute(development.glare));
  return encode(film, header);
}

struct ExrWriter::State : RowsFile {
  using RowsFile::RowsFile;
};

ExrWriter::ExrWriter(const Film& top, int rows) {
  require_layers(top);
  state_ = std::make_unique<State>(header_of(top, rows));
}

ExrWriter::~ExrWriter() = default;

void ExrWriter::add(const Film& rows) {
  state_->add(rows);
}

std::vector<std::uint8_t> ExrWriter::take() {
  return state_->take();
}

}  // namespace aerostat::image
