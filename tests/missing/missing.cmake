# Configures the checkout with something hidden, and expects it to stop with one sentence.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE ${WORK_DIR})
# find_path looks again where its answer was NOTFOUND: there it must not find what it looks for.
set(nowhere)
if(HIDDEN MATCHES "NOTFOUND$")
  set(nowhere -DCMAKE_FIND_ROOT_PATH=${WORK_DIR}/empty -DCMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY)
  string(REGEX REPLACE "=.*" "" hidden ${HIDDEN})
  foreach(other GL CAIRO FREETYPE GLFW WEBP avcodec avformat avutil swscale)
    if(NOT "BOXREEL_${other}_INCLUDE_DIR" STREQUAL hidden)
      list(APPEND nowhere -DBOXREEL_${other}_INCLUDE_DIR=${WORK_DIR})
    endif()
  endforeach()
  foreach(other PNG_PNG ZLIB ImGui)
    list(APPEND nowhere -D${other}_INCLUDE_DIR=${WORK_DIR})
  endforeach()
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR} -G Ninja -DCMAKE_CXX_COMPILER=${CXX} -D${HIDDEN} ${nowhere}
    -DBOXREEL_BUILD_TESTS=ON
  RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
string(REGEX REPLACE "[ \n]+" " " said "${said}") # CMake breaks lines
string(FIND "${said}" "${WHAT}, which was not found; install it with: apt install ${PACKAGE} " at)
if(code EQUAL 0 OR at EQUAL -1)
  message(FATAL_ERROR "Without ${WHAT} configuring ended with ${code} and said: ${said}")
endif()
