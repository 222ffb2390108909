# The engine alone, where no library of any kind can be found: boxreel builds, is installed, and another
# project simulates with it. What was not installed, and what cannot be found, is refused with a sentence.
include("${CMAKE_CURRENT_LIST_DIR}/Steps.cmake")
file(MAKE_DIRECTORY "${WORK_DIR}/nothing")
set(bare ${compiler} -DCMAKE_FIND_ROOT_PATH=${WORK_DIR}/nothing)
foreach(kind PACKAGE LIBRARY INCLUDE)
  list(APPEND bare -DCMAKE_FIND_ROOT_PATH_MODE_${kind}=ONLY)
endforeach()
set(prefix "${WORK_DIR}/prefix")
set(package "-Dboxreel_DIR=${prefix}/lib/cmake/boxreel")
set(fall "${CMAKE_CURRENT_LIST_DIR}/engine")

step("configuring the engine alone" COMMAND "${CMAKE_COMMAND}" ${bare} -S "${BOXREEL_DIR}" -B "${WORK_DIR}/boxreel"
  -DBOXREEL_BUILD_TOOLKIT=OFF -DCMAKE_INSTALL_LIBDIR=lib)
step("building it" COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}/boxreel")
step("installing it" COMMAND "${CMAKE_COMMAND}" --install "${WORK_DIR}/boxreel" --prefix "${prefix}")

foreach(asked engine "") # none: all that is installed
  step("configuring with '${asked}'" COMMAND "${CMAKE_COMMAND}" --fresh ${bare} ${package} -DCOMPONENTS=${asked}
    -S "${fall}" -B "${WORK_DIR}/fall")
  step("building" COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}/fall")
  foreach(program fall fall24)
    step("running ${program}" OUTPUT said COMMAND "${WORK_DIR}/fall/${program}")
    expect_text("${said}" "after a second it falls at -10.0 m/s")
  endforeach()
endforeach()

step("asking for what is not installed" FAILS OUTPUT said COMMAND "${CMAKE_COMMAND}" ${bare} ${package}
  -DCOMPONENTS=golden -S "${fall}" -B "${WORK_DIR}/golden")
string(REGEX REPLACE "[ \n]+" " " said "${said}")
expect_text("${said}" "The component 'golden' of boxreel is not installed in ${prefix}"
  "-DBOXREEL_BUILD_TOOLKIT=ON and install it again")
step("asking for what there is not" FAILS OUTPUT said COMMAND "${CMAKE_COMMAND}" ${bare} ${package}
  -DCOMPONENTS=window -S "${fall}" -B "${WORK_DIR}/window")
expect_text("${said}" "boxreel has no component 'window'")
# docs/versions.md: until 1.0 another second number is another interface.
step("asking for the next version" FAILS OUTPUT said COMMAND "${CMAKE_COMMAND}" ${bare} ${package}
  -DASKED_VERSION=0.2 -S "${fall}" -B "${WORK_DIR}/next")
expect_text("${said}" "version: 0.1.")

# All of it installed, and still no library to be found.
step("installing all" COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/all")
file(GLOB_RECURSE config "${WORK_DIR}/all/*/boxreelConfig.cmake")
get_filename_component(all "${config}" DIRECTORY)
foreach(asked engine drawlist debugdraw goldenstate)
  step("configuring with ${asked} of all" COMMAND "${CMAKE_COMMAND}" --fresh ${bare} -Dboxreel_DIR=${all}
    "-DCOMPONENTS=engine ${asked}" -S "${fall}" -B "${WORK_DIR}/of-all")
endforeach()
step("asking for what links a library" FAILS OUTPUT said COMMAND "${CMAKE_COMMAND}" --fresh ${bare}
  -Dboxreel_DIR=${all} -DCOMPONENTS=recorder -S "${fall}" -B "${WORK_DIR}/of-all")
string(REGEX REPLACE "[ \n]+" " " said "${said}")
expect_text("${said}" "The component 'render' of boxreel links PNG, which was not found; install it with: apt install libpng-dev")
