# This script fails if lupdate would change the translations TS, or if a text in them has no
# translation.
cmake_minimum_required(VERSION 3.25)
file(COPY_FILE "${TS}" "${COPY}")
execute_process(COMMAND "${LUPDATE}" ${ARGUMENTS} -ts "${COPY}" COMMAND_ERROR_IS_FATAL ANY)
file(READ "${TS}" before)
file(READ "${COPY}" after)
if(after MATCHES "type=\"unfinished\"")
  message(FATAL_ERROR "${TS}: some texts have no translation (see ${COPY})")
endif()
if(NOT before STREQUAL after)
  message(FATAL_ERROR "${TS} is out of date (see ${COPY}); expected: the output of the target update_translations")
endif()
