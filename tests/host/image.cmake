find_path(AEROSTAT_STB_INCLUDE stb_image_write.h PATH_SUFFIXES stb REQUIRED)

aerostat_test(image_test LABEL unit LINKS aerostat::image OpenEXR::OpenEXR
              SOURCES image_tone_test.cpp image_deflate_test.cpp image_sheet_test.cpp
                      image_white_test.cpp)
target_include_directories(image_test SYSTEM PRIVATE "${AEROSTAT_STB_INCLUDE}")
