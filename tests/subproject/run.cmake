# cmake -D BOXREEL_DIR=… -D WORK_DIR=… -D CXX=… -D NM=… -P run.cmake
# Configures and builds parent/ as a project of its own and looks at what came out.
foreach(needed BOXREEL_DIR WORK_DIR CXX NM)
  if(NOT ${needed})
    message(FATAL_ERROR "${needed} is not given")
  endif()
endforeach()

# Objects of the last run are kept, its settings are not.
set(build "${WORK_DIR}/parent")
execute_process(COMMAND "${CMAKE_COMMAND}" --fresh -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/parent" -B "${build}"
                        -DCMAKE_CXX_COMPILER=${CXX} -DBOXREEL_DIR=${BOXREEL_DIR}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${build}" --target parent_plain parent_film
                COMMAND_ERROR_IS_FATAL ANY)

set(program "${build}/parents-programs/parent_film")
if(NOT EXISTS "${program}")
  message(FATAL_ERROR "${program} is missing: the parent's output folder was not used")
endif()

# The toolkit links without the engine: it was not even built, and no name of it is in the program.
file(GLOB_RECURSE engine "${build}/*boxreel_engine*.a")
if(engine)
  message(FATAL_ERROR "drawing and recording made the engine build: ${engine}")
endif()
execute_process(COMMAND "${NM}" -C "${program}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES "boxreel::Renderer" OR NOT symbols MATCHES "boxreel::VideoWriter")
  message(FATAL_ERROR "the program's symbols do not name the renderer and the writer; nothing can be told from them")
endif()
if(symbols MATCHES "b2[A-Z][A-Za-z]*|box2d::[A-Za-z]*")
  message(FATAL_ERROR "the program without an engine contains ${CMAKE_MATCH_0}")
endif()

# Nothing of boxreel is installed with the parent, unless it is asked for, and then the parent keeps its settings too.
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${build}" --prefix "${WORK_DIR}/prefix" COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE installed "${WORK_DIR}/prefix/*")
if(installed)
  message(FATAL_ERROR "the parent's installation has ${installed}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/parent" -B "${WORK_DIR}/installing"
                        -DCMAKE_CXX_COMPILER=${CXX} -DBOXREEL_DIR=${BOXREEL_DIR} -DBOXREEL_INSTALL=ON
                        -DCMAKE_INSTALL_PREFIX=${WORK_DIR}/prefix -DCMAKE_INSTALL_LIBDIR=${WORK_DIR}/archives
                COMMAND_ERROR_IS_FATAL ANY)
file(READ "${WORK_DIR}/installing/boxreel/pkgconfig/boxreel-engine.pc" pc)
if(NOT pc MATCHES "libdir=${WORK_DIR}/archives\nincludedir=${WORK_DIR}/prefix/include\n")
  message(FATAL_ERROR "the files for pkg-config do not know where libraries are installed: ${pc}")
endif()
file(READ "${WORK_DIR}/installing/boxreel/cmake_install.cmake" script)
if(NOT script MATCHES "boxreelConfig.cmake" OR NOT script MATCHES "libboxreel_golden.a")
  message(FATAL_ERROR "with BOXREEL_INSTALL=ON the parent does not install the package and its libraries")
endif()

# What the parent compiles itself knows nothing of boxreel's flags.
file(READ "${build}/compile_commands.json" commands)
string(JSON count LENGTH "${commands}")
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
  string(JSON file GET "${commands}" ${i} file)
  string(JSON command GET "${commands}" ${i} command)
  if(file MATCHES "/plain\\.cpp$" AND command MATCHES "-ffp-contract|-Wall|-Wpedantic|-std=c\\+\\+")
    message(FATAL_ERROR "the parent's own file is compiled with ${CMAKE_MATCH_0}: ${command}")
  endif()
  # Compiled together, those sources would not compile: the parent asks for it.
  if(file MATCHES "boxreel_engine.dir/Unity")
    message(FATAL_ERROR "the parent's CMAKE_UNITY_BUILD has the engine compiled as one: ${file}")
  endif()
  if(NOT file MATCHES "/tests/subproject/parent/|/parent_film.dir/Unity/" AND NOT command MATCHES "-ffp-contract=off")
    message(FATAL_ERROR "a file of boxreel lost -ffp-contract=off in a subproject: ${command}")
  endif()
endforeach()

execute_process(COMMAND "${program}" "${WORK_DIR}/square.mp4" COMMAND_ERROR_IS_FATAL ANY)
file(SIZE "${WORK_DIR}/square.mp4" size)
if(size LESS 500)
  message(FATAL_ERROR "the film has only ${size} bytes")
endif()
message(STATUS "a film of ${size} bytes, made without the engine")
