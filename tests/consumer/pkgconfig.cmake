# Without CMake: a program that makes a film, compiled with what pkg-config says; and the same after the
# prefix was moved.
include("${CMAKE_CURRENT_LIST_DIR}/Steps.cmake")
set(prefix "${WORK_DIR}/moved")
step("installing" COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/prefix")
file(RENAME "${WORK_DIR}/prefix" "${prefix}")
file(GLOB_RECURSE pc "${prefix}/*/boxreel-recorder.pc")
get_filename_component(folder "${pc}" DIRECTORY)

# compile(PROGRAM SOURCE STANDARD PACKAGE [FLAG …])
function(compile program source standard package)
  step("pkg-config ${package}" OUTPUT flags COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${folder}"
    "${PKG_CONFIG}" --static --cflags --libs ${package})
  separate_arguments(flags UNIX_COMMAND "${flags}")
  step("compiling ${program}" COMMAND "${CXX}" -std=${standard} ${ARGN} "${source}" -o "${WORK_DIR}/${program}"
    ${flags})
endfunction()

compile(film "${BOXREEL_DIR}/docs/examples/film_pixels.cpp" c++20 boxreel-recorder)
execute_process(COMMAND "${WORK_DIR}/film" WORKING_DIRECTORY "${WORK_DIR}" COMMAND_ERROR_IS_FATAL ANY)
expect_file("${WORK_DIR}/rise.webp")
foreach(flags "" -DFALL_24) # the engine's headers need less than the others
  compile(fall "${CMAKE_CURRENT_LIST_DIR}/engine/fall.cpp" c++17 boxreel-engine ${flags})
  step("running it" OUTPUT said COMMAND "${WORK_DIR}/fall")
  expect_text("${said}" "it falls at -10.0 m/s")
endforeach()
compile(seesaw "${CMAKE_CURRENT_LIST_DIR}/world.cpp" c++20 boxreel-goldenworld)
step("running it" COMMAND "${WORK_DIR}/seesaw")

# The program came along, with what a shell and man read.
step("the program" OUTPUT said COMMAND "${prefix}/bin/boxreel" --version)
expect_text("${said}" "${VERSION}")
step("bash reads the completion" COMMAND bash -n "${prefix}/share/bash-completion/completions/boxreel")
step("zsh reads the completion" COMMAND zsh -n "${prefix}/share/zsh/site-functions/_boxreel")
file(READ "${prefix}/share/man/man1/boxreel.1" manual)
expect_text("${manual}" ".TH")
file(GLOB licence "${prefix}/share/doc/*/LICENSE")
expect_file("${licence}")
