aerostat_test(file_test LABEL unit LINKS aerostat::core)
