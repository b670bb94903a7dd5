#include "scene/objects.hpp"

#include "core/error.hpp"

namespace aerostat::scene {

std::string object_name(ObjectId id) {
  switch (id) {
    case ObjectId::sky:
      return "sky";
    case ObjectId::terrain:
      return "terrain";
    case ObjectId::water:
      return "water";
    case ObjectId::envelope:
      return "envelope";
    case ObjectId::skirt:
      return "skirt";
    case ObjectId::basket:
      return "basket";
    case ObjectId::rim:
      return "rim";
    case ObjectId::frame:
      return "frame";
    case ObjectId::cables:
      return "cables";
    case ObjectId::floor:
      return "floor";
    case ObjectId::flame:
      return "flame";
    case ObjectId::plant:
      return "plant";
    case ObjectId::stone:
      return "stone";
    case ObjectId::model:
      return "model";
    case ObjectId::track:
      return "track";
    case ObjectId::passenger:
      return "passenger";
    case ObjectId::count:
      break;
  }
  throw Error(ErrorKind::internal, "an object id is out of range");
}

}  // namespace aerostat::scene
