# Writes INPUT, a text file, into OUTPUT as a C++ string.
file(READ "${INPUT}" text)
file(WRITE "${OUTPUT}" "#include \"scene/schema.hpp\"\n\n"
     "namespace aerostat::scene::detail {\n\n"
     "const char* const kSchemaText = R\"schema(${text})schema\";\n\n"
     "}  // namespace aerostat::scene::detail\n")
