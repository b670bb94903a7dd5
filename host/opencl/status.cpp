#include "opencl/status.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::opencl {
namespace {

/// The status of the extension cl_khr_icd that says that no driver is registered.
constexpr int kNoIcd = -1001;
/// NVIDIA's status for a kernel that accessed memory outside its buffers.
constexpr int kIllegalAccess = -9999;

#define AEROSTAT_STATUS(name)   \
  std::pair<int, const char*> { \
    name, #name                 \
  }
constexpr std::array kStatusNames{
    AEROSTAT_STATUS(CL_SUCCESS),
    AEROSTAT_STATUS(CL_DEVICE_NOT_FOUND),
    AEROSTAT_STATUS(CL_DEVICE_NOT_AVAILABLE),
    AEROSTAT_STATUS(CL_COMPILER_NOT_AVAILABLE),
    AEROSTAT_STATUS(CL_MEM_OBJECT_ALLOCATION_FAILURE),
    AEROSTAT_STATUS(CL_OUT_OF_RESOURCES),
    AEROSTAT_STATUS(CL_OUT_OF_HOST_MEMORY),
    AEROSTAT_STATUS(CL_PROFILING_INFO_NOT_AVAILABLE),
    AEROSTAT_STATUS(CL_MEM_COPY_OVERLAP),
    AEROSTAT_STATUS(CL_IMAGE_FORMAT_MISMATCH),
    AEROSTAT_STATUS(CL_IMAGE_FORMAT_NOT_SUPPORTED),
    AEROSTAT_STATUS(CL_BUILD_PROGRAM_FAILURE),
    AEROSTAT_STATUS(CL_MAP_FAILURE),
    AEROSTAT_STATUS(CL_MISALIGNED_SUB_BUFFER_OFFSET),
    AEROSTAT_STATUS(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST),
    AEROSTAT_STATUS(CL_COMPILE_PROGRAM_FAILURE),
    AEROSTAT_STATUS(CL_LINKER_NOT_AVAILABLE),
    AEROSTAT_STATUS(CL_LINK_PROGRAM_FAILURE),
    AEROSTAT_STATUS(CL_DEVICE_PARTITION_FAILED),
    AEROSTAT_STATUS(CL_KERNEL_ARG_INFO_NOT_AVAILABLE),
    AEROSTAT_STATUS(CL_INVALID_VALUE),
    AEROSTAT_STATUS(CL_INVALID_DEVICE_TYPE),
    AEROSTAT_STATUS(CL_INVALID_PLATFORM),
    AEROSTAT_STATUS(CL_INVALID_DEVICE),
    AEROSTAT_STATUS(CL_INVALID_CONTEXT),
    AEROSTAT_STATUS(CL_INVALID_QUEUE_PROPERTIES),
    AEROSTAT_STATUS(CL_INVALID_COMMAND_QUEUE),
    AEROSTAT_STATUS(CL_INVALID_HOST_PTR),
    AEROSTAT_STATUS(CL_INVALID_MEM_OBJECT),
    AEROSTAT_STATUS(CL_INVALID_IMAGE_FORMAT_DESCRIPTOR),
    AEROSTAT_STATUS(CL_INVALID_IMAGE_SIZE),
    AEROSTAT_STATUS(CL_INVALID_SAMPLER),
    AEROSTAT_STATUS(CL_INVALID_BINARY),
    AEROSTAT_STATUS(CL_INVALID_BUILD_OPTIONS),
    AEROSTAT_STATUS(CL_INVALID_PROGRAM),
    AEROSTAT_STATUS(CL_INVALID_PROGRAM_EXECUTABLE),
    AEROSTAT_STATUS(CL_INVALID_KERNEL_NAME),
    AEROSTAT_STATUS(CL_INVALID_KERNEL_DEFINITION),
    AEROSTAT_STATUS(CL_INVALID_KERNEL),
    AEROSTAT_STATUS(CL_INVALID_ARG_INDEX),
    AEROSTAT_STATUS(CL_INVALID_ARG_VALUE),
    AEROSTAT_STATUS(CL_INVALID_ARG_SIZE),
    AEROSTAT_STATUS(CL_INVALID_KERNEL_ARGS),
    AEROSTAT_STATUS(CL_INVALID_WORK_DIMENSION),
    AEROSTAT_STATUS(CL_INVALID_WORK_GROUP_SIZE),
    AEROSTAT_STATUS(CL_INVALID_WORK_ITEM_SIZE),
    AEROSTAT_STATUS(CL_INVALID_GLOBAL_OFFSET),
    AEROSTAT_STATUS(CL_INVALID_EVENT_WAIT_LIST),
    AEROSTAT_STATUS(CL_INVALID_EVENT),
    AEROSTAT_STATUS(CL_INVALID_OPERATION),
    AEROSTAT_STATUS(CL_INVALID_BUFFER_SIZE),
    AEROSTAT_STATUS(CL_INVALID_GLOBAL_WORK_SIZE),
    AEROSTAT_STATUS(CL_INVALID_PROPERTY),
    AEROSTAT_STATUS(CL_INVALID_COMPILER_OPTIONS),
    AEROSTAT_STATUS(CL_INVALID_LINKER_OPTIONS),
    AEROSTAT_STATUS(CL_INVALID_DEVICE_PARTITION_COUNT),
    std::pair<int, const char*>{kNoIcd, "CL_PLATFORM_NOT_FOUND_KHR"},
    std::pair<int, const char*>{kIllegalAccess, "illegal access by a kernel (-9999)"},
};
#undef AEROSTAT_STATUS

/// Returns a message on why the device cannot go on, or null if the fault is in the program.
const char* exhaustion(int status) {
  switch (status) {
    case CL_MEM_OBJECT_ALLOCATION_FAILURE:
    case CL_OUT_OF_HOST_MEMORY:
    case CL_MAP_FAILURE:
      return "there is not enough memory";
    case CL_INVALID_BUFFER_SIZE:
      return "the device has no room for a buffer of that size";
    case CL_OUT_OF_RESOURCES:
      return "the device ran out of memory or other resources, or was lost";
    case CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST:
      return "an earlier command on the device failed";
    case CL_DEVICE_NOT_AVAILABLE:
    case kIllegalAccess:
      return "the device was lost or stopped working";
    default:
      return nullptr;
  }
}

}  // namespace

std::string status_name(int status) {
  for (const auto& [value, name] : kStatusNames) {
    if (value == status) return name;
  }
  return fmt::format("OpenCL status {}", status);
}

std::string status_text(const cl::Error& error) {
  return fmt::format("{} from {}", status_name(error.err()),
                     error.what() != nullptr ? error.what() : "OpenCL");
}

bool is_out_of_memory(int status) {
  return status == CL_OUT_OF_HOST_MEMORY || status == CL_MEM_OBJECT_ALLOCATION_FAILURE;
}

bool is_exhaustion(int status) {
  return exhaustion(status) != nullptr;
}

void rethrow(const char* doing, const cl::Error& error) {
  const auto detail = status_text(error);
  if (const char* reason = exhaustion(error.err())) {
    throw Error(ErrorKind::exhausted, fmt::format("while {}: {} ({})", doing, reason, detail));
  }
  throw Error(ErrorKind::internal, fmt::format("while {}: {}", doing, detail));
}

}  // namespace aerostat::opencl
