# For the scripts of this folder: what is done in each, and seen to end as it should.
cmake_policy(VERSION 3.25)

# step(WHAT [FAILS] [OUTPUT VARIABLE] COMMAND …): stops with what was printed unless the command ends with 0
# (with FAILS: with something else).
function(step what)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "FAILS" "OUTPUT" "COMMAND")
  execute_process(COMMAND ${ARG_COMMAND} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if((ARG_FAILS AND code EQUAL 0) OR (NOT ARG_FAILS AND NOT code EQUAL 0))
    message(FATAL_ERROR "${what}: ended with ${code}\n${output}")
  endif()
  if(ARG_OUTPUT)
    set(${ARG_OUTPUT} "${output}" PARENT_SCOPE)
  endif()
  message(STATUS "${what}: as expected")
endfunction()

# expect_text(TEXT SUBSTRING …)
function(expect_text text)
  foreach(part IN LISTS ARGN)
    string(FIND "${text}" "${part}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "'${part}' is not said in\n${text}")
    endif()
  endforeach()
endfunction()

function(expect_file)
  foreach(file IN LISTS ARGN)
    if(NOT EXISTS "${file}")
      message(FATAL_ERROR "${file} is missing")
    endif()
  endforeach()
endfunction()

# replace_in(FILE FROM TO): a planted change, which must be one.
function(replace_in file from to)
  file(READ "${file}" before)
  string(REPLACE "${from}" "${to}" after "${before}")
  if(before STREQUAL after)
    message(FATAL_ERROR "${file} does not say '${from}', so nothing was planted")
  endif()
  file(WRITE "${file}" "${after}")
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")
set(compiler -G Ninja -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Debug)
