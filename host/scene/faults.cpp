#include "scene/faults.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "scene/locate.hpp"

namespace aerostat::scene {

namespace {

constexpr std::size_t kMostTold = 50;

std::string told(const Fault& fault) {
  return fmt::format("{}: found {}, expected {}", detail::to_string(fault.pointer), fault.found,
                     fault.expected);
}

}  // namespace

BadScene::BadScene(const std::string& name, std::vector<Fault> faults)
    : Error(ErrorKind::bad_data, fmt::format("{}: {}", name, told(faults.front()))),
      name_(name),
      faults_(std::move(faults)) {}

std::vector<std::string> BadScene::lines() const {
  std::vector<Fault> faults = faults_;
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  std::vector<std::string> lines;
  for (const Fault& fault : faults) {
    if (lines.size() == kMostTold) {
      lines.push_back(fmt::format("{}: and {} more faults", name_, faults.size() - kMostTold));
      break;
    }
    const std::string place =
        fault.line > 0 ? fmt::format("{}:{}:{}", name_, fault.line, fault.column) : name_;
    lines.push_back(fmt::format("{}: {}", place, told(fault)));
  }
  return lines;
}

namespace detail {

bool is_within(const Pointer& pointer, const Pointer& ancestor) {
  return pointer.size() >= ancestor.size() &&
         std::equal(ancestor.begin(), ancestor.end(), pointer.begin());
}

void Faults::add(Pointer pointer, std::string found, std::string expected) {
  faults_.push_back({std::move(pointer), std::move(found), std::move(expected)});
}

void Faults::forget_after(std::size_t count, const std::vector<Pointer>& pointers) {
  const auto forgotten = [&pointers](const Fault& fault) {
    return std::any_of(pointers.begin(), pointers.end(), [&fault](const Pointer& pointer) {
      return is_within(fault.pointer, pointer);
    });
  };
  const auto first = faults_.begin() + static_cast<std::ptrdiff_t>(count);
  faults_.erase(std::remove_if(first, faults_.end(), forgotten), faults_.end());
}

bool Faults::is_overridden(const Pointer& pointer) const {
  return std::any_of(overridden_.begin(), overridden_.end(),
                     [&pointer](const Pointer& other) { return is_within(pointer, other); });
}

void Faults::throw_if_any() const {
  if (faults_.empty()) return;
  std::vector<Fault> faults = faults_;
  for (Fault& fault : faults) {
    if (text_.empty() || is_overridden(fault.pointer)) continue;
    const TextPlace place = locate(text_, fault.pointer);
    fault.line = place.line;
    fault.column = place.column;
  }
  throw BadScene(name_, std::move(faults));
}

}  // namespace detail

}  // namespace aerostat::scene
