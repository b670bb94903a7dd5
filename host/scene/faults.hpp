#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/bad_scene.hpp"
#include "scene/json_text.hpp"

namespace aerostat::scene::detail {

/// Collects all faults of one scene while it is read, so that all of them can be told.
class Faults {
 public:
  /// Takes the `name` that stands for the file in messages, and the `text` of the scene, which
  /// gives lines and columns. `text` may be empty. It must live as long as this object.
  explicit Faults(std::string name, std::string_view text = {})
      : name_(std::move(name)), text_(text) {}

  const std::string& name() const { return name_; }
  bool empty() const { return faults_.empty(); }

  void add(Pointer pointer, std::string found, std::string expected);

  /// Runs a check that may throw a BadScene, and keeps the faults of that error.
  template <typename Check>
  void gather(const Check& check) {
    try {
      check();
    } catch (const BadScene& bad) {
      faults_.insert(faults_.end(), bad.faults().begin(), bad.faults().end());
    }
  }

  /// Notes that the value at this pointer does not come from the text.
  void set_overridden(Pointer pointer) { overridden_.push_back(std::move(pointer)); }

  /// Forgets the faults at or below these pointers that were added after the first `count`
  /// faults.
  void forget_after(std::size_t count, const std::vector<Pointer>& pointers);
  std::size_t count() const { return faults_.size(); }
  const Pointer& pointer(std::size_t i) const { return faults_[i].pointer; }

  /// Throws BadScene if there is any fault.
  void throw_if_any() const;

 private:
  bool is_overridden(const Pointer& pointer) const;

  std::string name_;
  std::string_view text_;
  std::vector<Fault> faults_;
  std::vector<Pointer> overridden_;
};

/// Returns whether `pointer` is `ancestor` or leads to a part of it.
bool is_within(const Pointer& pointer, const Pointer& ancestor);

}  // namespace aerostat::scene::detail
