#include "geo/proj_objects.hpp"

#include <new>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::geo {
namespace {

Error error_of(const std::string& text, const std::string& reason) {
  return Error(ErrorKind::bad_data,
               fmt::format("cannot use the coordinate reference system \"{}\": {}", shortened(text),
                           reason));
}

bool is_geographic(PJ_TYPE type) {
  return type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
}

}  // namespace

ProjContext::ProjContext() : context_(proj_context_create()) {
  if (!context_) throw Error(ErrorKind::exhausted, "cannot start PROJ: out of memory");
  proj_log_func(context_.get(), this, keep_complaint);
  proj_context_set_enable_network(context_.get(), 0);
  proj_context_use_proj4_init_rules(context_.get(), 0);
  if (proj_context_get_database_path(context_.get()) == nullptr) {
    throw Error(ErrorKind::io,
                "cannot use coordinates on the Earth: PROJ does not find its file proj.db "
                "(the package proj-data has it)");
  }
}

void ProjContext::keep_complaint(void* self, int, const char* message) {
  try {
    std::string text = message == nullptr ? "" : message;
    // PROJ begins a message with the name of its function.
    const std::size_t colon = text.find(": ");
    if (text.compare(0, 5, "proj_") == 0 && colon != std::string::npos) text.erase(0, colon + 2);
    static_cast<ProjContext*>(self)->complaint_ = shortened(text);
  } catch (const std::bad_alloc&) {
    // The error that is made of the complaint does without it.
  }
}

ProjObject ProjContext::crs(const std::string& text) const {
  const std::string refusal = refusal_of_crs_text(text);
  if (!refusal.empty()) throw error_of(text, refusal);
  std::string definition = text;
  const bool is_proj_string =
      text.find("proj=") != std::string::npos && text.find('[') == std::string::npos;
  if (is_proj_string && text.find("type=crs") == std::string::npos) definition += " +type=crs";
  ProjObject result(proj_create(context_.get(), definition.c_str()));
  if (!result) {
    throw error_of(text, complaint_.empty()
                             ? "PROJ does not know it"
                             : fmt::format("PROJ does not know it ({})", complaint_));
  }
  if (proj_is_crs(result.get()) == 0) throw error_of(text, "it is no coordinate reference system");
  return result;
}

ProjObject ProjContext::horizontal(const ProjObject& crs, const std::string& text) const {
  ProjObject part(proj_clone(context_.get(), crs.get()));
  if (part && proj_get_type(part.get()) == PJ_TYPE_COMPOUND_CRS) {
    part.reset(proj_crs_get_sub_crs(context_.get(), part.get(), 0));
  }
  // A bound system is another one together with a shift of datum, which the transformation needs.
  ProjObject base(part ? proj_clone(context_.get(), part.get()) : nullptr);
  while (base && proj_get_type(base.get()) == PJ_TYPE_BOUND_CRS) {
    base.reset(proj_get_source_crs(context_.get(), base.get()));
  }
  const PJ_TYPE type = base ? proj_get_type(base.get()) : PJ_TYPE_UNKNOWN;
  if (!is_geographic(type) && type != PJ_TYPE_PROJECTED_CRS) {
    throw error_of(text, "it is neither geographic nor projected");
  }
  return part;
}

bool ProjContext::knows_datum(const PJ* crs) const {
  // PROJ gives 70 of 100 to a system of the same numbers whose name is nearly the same.
  constexpr int kLeastSure = 70;
  const ProjObject base(proj_crs_get_geodetic_crs(context_.get(), crs));
  if (!base) return false;
  int* sure = nullptr;
  const std::unique_ptr<PJ_OBJ_LIST, DestroyProj> found(
      proj_identify(context_.get(), base.get(), nullptr, nullptr, &sure));
  const std::unique_ptr<int, DestroyProj> owner(sure);
  return found && proj_list_get_count(found.get()) > 0 && sure[0] >= kLeastSure;
}

}  // namespace aerostat::geo
