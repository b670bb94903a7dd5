#include "take_scene.hpp"

#include <exception>

#include "core/error.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::test {

std::string fault_of_scene(const std::string& text, const std::vector<std::string>& changes) {
  bool is_read = false;
  std::string written;
  try {
    std::vector<scene::Override> overrides;
    for (const std::string& change : changes) overrides.push_back(scene::parse_override(change));
    written = scene::write_text(scene::read_text(text, "fuzz.json", overrides));
    is_read = true;
    const std::string again = scene::write_text(scene::read_text(written, "fuzz.json"));
    return again == written ? "" : "it reads as another scene than it was written";
  } catch (const Error& error) {
    if (is_read) return std::string("what was written is refused: ") + error.what();
    const bool is_set = error.kind() == ErrorKind::usage && !changes.empty();
    if (error.kind() != ErrorKind::bad_data && !is_set) return error.what();
    const std::string message = error.what();
    const bool says_where = message.find("fuzz.json") != std::string::npos ||
                            message.find("--set") != std::string::npos;
    return says_where ? "" : "a message without a place: " + message;
  } catch (const std::exception& error) {
    return std::string("not an error of aerostat's own: ") + error.what();
  }
}

}  // namespace aerostat::test
