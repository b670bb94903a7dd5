aerostat_test(air_test LABEL unit LINKS aerostat::air SOURCES air_haze_test.cpp
              air_sky_test.cpp air_twilight_test.cpp)
