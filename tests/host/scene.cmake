aerostat_test(scene_test LABEL unit LINKS aerostat::scene)
aerostat_test(scene_error_test LABEL unit LINKS aerostat::scene)
aerostat_test(scene_schema_test LABEL unit LINKS aerostat::scene nlohmann_json::nlohmann_json)
aerostat_test(sun_position_test LABEL unit LINKS aerostat::scene)
