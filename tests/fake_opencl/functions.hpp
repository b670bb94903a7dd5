#pragma once

#include <array>
#include <cstddef>

/// The functions of OpenCL that the fake driver (fake_driver.cpp) stands in front of.
#define AEROSTAT_FAKED_FUNCTIONS(F) \
  F(clGetPlatformInfo)              \
  F(clGetDeviceIDs)                 \
  F(clGetDeviceInfo)                \
  F(clCreateSubDevices)             \
  F(clRetainDevice)                 \
  F(clReleaseDevice)                \
  F(clCreateContext)                \
  F(clRetainContext)                \
  F(clReleaseContext)               \
  F(clGetContextInfo)               \
  F(clCreateCommandQueue)           \
  F(clRetainCommandQueue)           \
  F(clReleaseCommandQueue)          \
  F(clGetCommandQueueInfo)          \
  F(clCreateBuffer)                 \
  F(clRetainMemObject)              \
  F(clReleaseMemObject)             \
  F(clGetMemObjectInfo)             \
  F(clCreateProgramWithSource)      \
  F(clCreateProgramWithBinary)      \
  F(clBuildProgram)                 \
  F(clGetProgramInfo)               \
  F(clGetProgramBuildInfo)          \
  F(clRetainProgram)                \
  F(clReleaseProgram)               \
  F(clCreateKernel)                 \
  F(clSetKernelArg)                 \
  F(clGetKernelInfo)                \
  F(clGetKernelWorkGroupInfo)       \
  F(clRetainKernel)                 \
  F(clReleaseKernel)                \
  F(clWaitForEvents)                \
  F(clGetEventInfo)                 \
  F(clGetEventProfilingInfo)        \
  F(clRetainEvent)                  \
  F(clReleaseEvent)                 \
  F(clFlush)                        \
  F(clFinish)                       \
  F(clEnqueueReadBuffer)            \
  F(clEnqueueWriteBuffer)           \
  F(clEnqueueFillBuffer)            \
  F(clEnqueueCopyBuffer)            \
  F(clEnqueueMapBuffer)             \
  F(clEnqueueUnmapMemObject)        \
  F(clEnqueueNDRangeKernel)

namespace aerostat::test {

#define AEROSTAT_NAME_OF(function) #function,
inline constexpr std::array kFakedFunctions{AEROSTAT_FAKED_FUNCTIONS(AEROSTAT_NAME_OF)};
#undef AEROSTAT_NAME_OF

}  // namespace aerostat::test
