aerostat_test(opencl_test LABEL unit LINKS aerostat::opencl aerostat_kernel_sources
              SOURCES opencl_cache_check_test.cpp opencl_cache_test.cpp opencl_run_test.cpp)

# A process of its own: its device has three compute units.
aerostat_test(opencl_selection_test LABEL unit LINKS aerostat::opencl)
