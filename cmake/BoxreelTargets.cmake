# How every target of this project is compiled. Nothing here touches global flags, so a parent
# project that uses add_subdirectory keeps its own.

# Same input, same bits: no fused multiply-add, no fast-math, for every default of a compiler.
set(BOXREEL_COMPILE_OPTIONS -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                            -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)

# GCC 12 takes "a" + std::string for an overflow, depending on what it has inlined (GCC's bug 105651,
# fixed in 13). Later ones and clang look at the same code.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND BOXREEL_COMPILE_OPTIONS -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
       -Wno-array-bounds)
endif()

# GCC's garbage collector begins at 128 MB, which most sources here pass: a tenth of the time of compiling. In kB.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND BOXREEL_COMPILE_OPTIONS "SHELL:--param ggc-min-heapsize=500000")
endif()

# boxreel_configure(TARGET): language level, warnings, exact floating point, sanitizers.
function(boxreel_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Two sources may have the same names, so a parent's choice to compile sources together does not hold here.
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
  target_compile_options(${target} PRIVATE ${BOXREEL_COMPILE_OPTIONS})
  if(BOXREEL_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(BOXREEL_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${BOXREEL_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # Of instrumented code these guess wrong (GCC's manual, -Wmaybe-uninitialized); other builds have them.
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-restrict
                                               -Wno-stringop-overflow)
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${BOXREEL_SANITIZE})
  endif()
  if(BOXREEL_FUZZ) # the fuzzer sees which branches an input takes
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# boxreel_precompile(TARGET HEADERS …): reads the standard headers that most sources include, and those
# given, once for all of the target's: half of the time that a source takes to compile. A source still
# includes what it uses; the matrix builds without (CMAKE_DISABLE_PRECOMPILE_HEADERS).
function(boxreel_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map>
                            <memory> <optional> <set> <span> <string> <utility> <variant> <vector> ${ARGN})
endfunction()

# boxreel_add_library(NAME SOURCES … [LIGHT_SOURCES …] [PUBLIC …] [PRIVATE …]): the library
# boxreel::NAME of the current folder; its public headers are in include/. Light sources handle text
# and files, take no time that is measured, and are optimised little, as the program is.
function(boxreel_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIGHT_SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(boxreel_${name} STATIC ${ARG_SOURCES} ${ARG_LIGHT_SOURCES})
  set_source_files_properties(${ARG_LIGHT_SOURCES} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>)
  add_library(boxreel::${name} ALIAS boxreel_${name})
  set_target_properties(boxreel_${name} PROPERTIES EXPORT_NAME ${name})
  boxreel_configure(boxreel_${name})
  if(name STREQUAL "engine" OR name STREQUAL "base")
    boxreel_precompile(boxreel_${name})
  else() # base's are read once for all of the toolkit, which is compiled with the same options
    target_precompile_headers(boxreel_${name} REUSE_FROM boxreel_base)
  endif()
  target_include_directories(boxreel_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(boxreel_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()

# boxreel_build_fast(TARGET): what is compiled more often than it is run, and is no part of what is
# measured, is optimised little.
function(boxreel_build_fast target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# boxreel_build_fastest(TARGET): what is run once for each time it is compiled is not optimised at all:
# three fifths of the time with -O1.
function(boxreel_build_fastest target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
endfunction()

# Of tests that draw: the sanitizers are to overlook what Mesa itself does. In two properties, for a list
# in one would be taken apart on its way to CTest. Without the last option GCC 12's LeakSanitizer dies of the thread-local
# memory of libraries that were unloaded ("Tracer caught signal 11"), in seven of ten films that are resumed.
set(BOXREEL_MESA_PROPERTIES
  ENVIRONMENT "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/lsan.supp:print_suppressions=0:intercept_tls_get_addr=0"
  ENVIRONMENT_MODIFICATION
    "TSAN_OPTIONS=set:suppressions=${PROJECT_SOURCE_DIR}/tests/tsan.supp:print_suppressions=0")

# boxreel_add_tests(NAME [MESA] SOURCES … [LIBRARIES …] [LABELS …] [PROPERTIES …]): a GoogleTest program
# whose cases become CTest tests with the given labels (quick unless said). MESA: they draw.
function(boxreel_add_tests name)
  cmake_parse_arguments(ARG "MESA" "" "SOURCES;LIBRARIES;LABELS;PROPERTIES" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS quick)
  endif()
  set(timeout 300)
  if(BOXREEL_SANITIZE) # the thread sanitizer takes up to thirty times as long
    set(timeout 1800)
  endif()
  if(ARG_MESA)
    list(APPEND ARG_PROPERTIES ${BOXREEL_MESA_PROPERTIES})
  endif()
  add_executable(boxreel_${name}_tests ${ARG_SOURCES})
  boxreel_configure(boxreel_${name}_tests)
  boxreel_build_fastest(boxreel_${name}_tests)
  target_precompile_headers(boxreel_${name}_tests REUSE_FROM boxreel_test_headers)
  target_link_libraries(boxreel_${name}_tests PRIVATE ${ARG_LIBRARIES} GTest::gmock GTest::gtest_main)
  if(BOXREEL_HAS_GOLD_LINKER AND NOT BOXREEL_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_link_options(boxreel_${name}_tests PRIVATE -fuse-ld=gold)
  endif()
  gtest_discover_tests(boxreel_${name}_tests TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60
                       PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${timeout} ${ARG_PROPERTIES})
endfunction()
