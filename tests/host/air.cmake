aerostat_test(air_test LABEL unit LINKS aerostat::air SOURCES air_sky_test.cpp)
