aerostat_test(plant_test LABEL unit LINKS aerostat::plant)
