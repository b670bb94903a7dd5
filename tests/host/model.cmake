aerostat_test(mesh_test LABEL unit LINKS aerostat::mesh)
aerostat_test(envelope_test LABEL unit LINKS aerostat::model)
aerostat_test(balloon_test LABEL unit LINKS aerostat::model)
aerostat_test(balloons_world_test LABEL unit LINKS aerostat::pack aerostat::world)
