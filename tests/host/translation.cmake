aerostat_test(translation_test LABEL unit LINKS aerostat::core)
