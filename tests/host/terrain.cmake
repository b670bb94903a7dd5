aerostat_test(noise_test LABEL unit LINKS aerostat::terrain)
aerostat_test(terrain_test LABEL unit LINKS aerostat::terrain aerostat::mesh TBB::tbb)
