aerostat_test(scatter_test LABEL unit LINKS aerostat::scatter aerostat::terrain TBB::tbb)
aerostat_test(sight_test LABEL unit LINKS aerostat::scatter)
