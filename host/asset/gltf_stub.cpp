#include "asset/reading.hpp"
#include "asset/words.hpp"
namespace aerostat::asset {
void read_gltf(Reading&) {
  refuse("glTF is not read yet");
}
}  // namespace aerostat::asset
