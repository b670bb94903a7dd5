aerostat_test(scatter_test LABEL unit LINKS aerostat::scatter aerostat::terrain TBB::tbb)
aerostat_test(scatter_bounds_test LABEL unit LINKS aerostat::scatter aerostat::terrain)
aerostat_test(sight_test LABEL unit LINKS aerostat::scatter)
