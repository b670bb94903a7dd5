#pragma once

/// The classes of OpenCL's C++ bindings by name alone. Headers point to them, so that only the
/// sources of this folder read the bindings (cl.hpp), which are large.
namespace cl {
class Buffer;
class CommandQueue;
class Context;
class Device;
class Event;
class Kernel;
class Program;
}  // namespace cl
