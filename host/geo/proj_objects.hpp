#pragma once

#include <memory>
#include <string>

#include <proj.h>

#include "geo/crs_text.hpp"

namespace aerostat::geo {

struct DestroyProj {
  void operator()(PJ* object) const { proj_destroy(object); }
  void operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
  void operator()(PJ_OPERATION_FACTORY_CONTEXT* context) const {
    proj_operation_factory_context_destroy(context);
  }
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
  void operator()(int* numbers) const { proj_int_list_destroy(numbers); }
};
using ProjObject = std::unique_ptr<PJ, DestroyProj>;

/// A context of PROJ that uses no network and keeps its last complaint instead of printing it. One
/// thread uses it at a time.
class ProjContext {
 public:
  ProjContext();
  ProjContext(const ProjContext&) = delete;
  ProjContext& operator=(const ProjContext&) = delete;

  PJ_CONTEXT* get() const { return context_.get(); }
  const std::string& complaint() const { return complaint_; }

  /// Returns the coordinate reference system that a text describes. Throws Error{bad_data} with the
  /// text, shortened, and the reason if there is none.
  ProjObject crs(const std::string& text) const;

  /// Returns the geographic or projected system in `crs`, which may be compound. Throws
  /// Error{bad_data} as crs() does if there is none.
  ProjObject horizontal(const ProjObject& crs, const std::string& text) const;

  /// Returns whether the database of PROJ has the geographic system that `crs` stands on, by its
  /// code or by its name and numbers.
  bool knows_datum(const PJ* crs) const;

 private:
  static void keep_complaint(void* self, int level, const char* message);

  std::string complaint_;
  std::unique_ptr<PJ_CONTEXT, DestroyProj> context_;
};

}  // namespace aerostat::geo
