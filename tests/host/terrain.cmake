aerostat_test(gullies_test LABEL unit LINKS aerostat::terrain)
aerostat_test(noise_test LABEL unit LINKS aerostat::terrain)
aerostat_test(drainage_test LABEL unit LINKS aerostat::terrain TBB::tbb)
aerostat_test(terrain_test LABEL unit LINKS aerostat::terrain aerostat::mesh TBB::tbb)
