aerostat_test(opencl_test LABEL unit LINKS aerostat::opencl aerostat_kernel_sources
              SOURCES opencl_binaries_test.cpp opencl_cache_check_test.cpp opencl_cache_test.cpp opencl_registered_test.cpp
                      opencl_run_test.cpp)

aerostat_test(memory_left_test LABEL unit LINKS aerostat::core)
aerostat_test(kernel_progress_test LABEL unit LINKS aerostat::render)

# A process of its own: its device has three compute units.
aerostat_test(opencl_selection_test LABEL unit LINKS aerostat::opencl)
