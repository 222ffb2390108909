# What `cmake --install` copies: libraries, headers, the package for find_package, the files for
# pkg-config, the program with its manual page and completion, the licence. All but the program is the
# component `development`, a Debian package of its own (BoxreelPackage.cmake).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(BOXREEL_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/boxreel)
set(BOXREEL_HEADERS_DIR ${CMAKE_INSTALL_INCLUDEDIR}/boxreel)

# boxreel_install_library(NAME DESCRIPTION TEXT HEADERS DIR [NAMES SUFFIX] [NEEDS LIBRARY …] [PACKAGES PKGCONFIG …]
# [LIBS FLAG …]): the library boxreel::NAME with the headers below DIR/include, and below DIR/includeSUFFIX, which only
# users of this library find. NEEDS: others of ours; PACKAGES and LIBS: what
# a program that links it must link as well, for these are static libraries. boxreelConfig.cmake.in says
# the same for CMake.
function(boxreel_install_library name)
  cmake_parse_arguments(ARG "" "DESCRIPTION;HEADERS;NAMES" "NEEDS;PACKAGES;LIBS" ${ARGN})
  if(NOT TARGET boxreel_${name})
    return() # the engine alone is installed
  endif()
  set(folders ${BOXREEL_HEADERS_DIR})
  set(PC_NAMES)
  if(ARG_NAMES)
    list(APPEND folders ${BOXREEL_HEADERS_DIR}${ARG_NAMES})
    set(PC_NAMES " -I\${includedir}/boxreel${ARG_NAMES}")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${ARG_HEADERS}/include${ARG_NAMES}/
            DESTINATION ${BOXREEL_HEADERS_DIR}${ARG_NAMES} COMPONENT development)
  endif()
  # A set for each, so that the package reads only those that are asked for.
  install(TARGETS boxreel_${name} EXPORT boxreel-${name}-targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development INCLUDES DESTINATION ${folders})
  install(EXPORT boxreel-${name}-targets NAMESPACE boxreel:: DESTINATION ${BOXREEL_PACKAGE_DIR}
          COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${ARG_HEADERS}/include/ DESTINATION ${BOXREEL_HEADERS_DIR}
          COMPONENT development)

  # Relative, so that the prefix may be moved, unless whoever installs has named places that may not.
  if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
    set(PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
    set(PC_LIBDIR "${CMAKE_INSTALL_FULL_LIBDIR}")
    set(PC_INCLUDEDIR "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
  else()
    file(RELATIVE_PATH PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
    string(REGEX REPLACE "/$" "" PC_PREFIX "\${pcfiledir}/${PC_PREFIX}")
    set(PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
    set(PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
  endif()
  set(PC_NAME ${name})
  set(PC_DESCRIPTION "${ARG_DESCRIPTION}")
  list(TRANSFORM ARG_NEEDS PREPEND boxreel- OUTPUT_VARIABLE PC_REQUIRES)
  list(JOIN PC_REQUIRES " " PC_REQUIRES)
  list(JOIN ARG_PACKAGES " " PC_PACKAGES)
  list(JOIN ARG_LIBS " " PC_LIBS)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/boxreel.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/boxreel-${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/boxreel-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT development)
endfunction()

set(BOXREEL_LOAD_LIBRARIES)
if(CMAKE_DL_LIBS)
  set(BOXREEL_LOAD_LIBRARIES -l${CMAKE_DL_LIBS})
endif()
boxreel_install_library(engine HEADERS engine NAMES -2.4 DESCRIPTION "2D rigid bodies with the API of the Box2D 2.3 manual")
boxreel_install_library(base HEADERS base DESCRIPTION "Results, files and text that the toolkit shares"
  LIBS ${BOXREEL_LOAD_LIBRARIES})
boxreel_install_library(gzip HEADERS base DESCRIPTION "Texts in the gzip format" NEEDS base PACKAGES zlib)
boxreel_install_library(drawlist HEADERS debugdraw DESCRIPTION "What was asked to be drawn, and the camera" NEEDS base)
boxreel_install_library(debugdraw HEADERS debugdraw DESCRIPTION "The engine's debug drawing as a draw list"
  NEEDS drawlist engine)
boxreel_install_library(page HEADERS page DESCRIPTION "Draw lists become a web page that plays them"
  NEEDS drawlist gzip)
boxreel_install_library(render HEADERS render DESCRIPTION "Draw lists become pixels and figures, off-screen"
  NEEDS drawlist PACKAGES libpng imgui stb LIBS ${BOXREEL_LOAD_LIBRARIES})
boxreel_install_library(recorder HEADERS recorder DESCRIPTION "Frames become films"
  NEEDS render gzip LIBS ${BOXREEL_LOAD_LIBRARIES} -pthread)
boxreel_install_library(golden HEADERS golden DESCRIPTION "Pictures and draw lists against approved ones"
  NEEDS recorder gzip)
boxreel_install_library(goldenstate HEADERS golden DESCRIPTION "A world's state in 64 bits" NEEDS engine drawlist)
boxreel_install_library(goldenworld HEADERS golden DESCRIPTION "Worlds against approved ones"
  NEEDS golden debugdraw goldenstate)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/boxreelConfig.cmake.in
  ${PROJECT_BINARY_DIR}/boxreelConfig.cmake INSTALL_DESTINATION ${BOXREEL_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/boxreelConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/boxreelConfig.cmake ${PROJECT_BINARY_DIR}/boxreelConfigVersion.cmake
        DESTINATION ${BOXREEL_PACKAGE_DIR} COMPONENT development)
if(TARGET boxreel_golden)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/BoxreelGoldenTests.cmake ${PROJECT_SOURCE_DIR}/cmake/FindImGui.cmake
          DESTINATION ${BOXREEL_PACKAGE_DIR} COMPONENT development)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)

# boxreel_install_printed(DESTINATION FILE ARGUMENT …): what the program prints when it is called so.
function(boxreel_install_printed destination)
  set(file ${PROJECT_BINARY_DIR}/${destination})
  install(CODE "execute_process(COMMAND \"$<TARGET_FILE:boxreel>\" ${ARGN} OUTPUT_FILE \"${file}\"
                                COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
  get_filename_component(folder ${destination} DIRECTORY)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
  install(FILES ${file} DESTINATION ${folder} COMPONENT program)
endfunction()

if(TARGET boxreel)
  install(TARGETS boxreel RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  boxreel_install_printed(${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions/boxreel completion bash)
  boxreel_install_printed(${CMAKE_INSTALL_DATAROOTDIR}/zsh/site-functions/_boxreel completion zsh)
  boxreel_install_printed(${CMAKE_INSTALL_DATAROOTDIR}/man/man1/boxreel.1 man)
endif()

if(TARGET boxreel_python)
  # Where Debian's python3 looks; below another prefix it is named in PYTHONPATH.
  set(BOXREEL_PYTHON_INSTALL_DIR lib/python3/dist-packages)
  install(TARGETS boxreel_python LIBRARY DESTINATION ${BOXREEL_PYTHON_INSTALL_DIR} COMPONENT python)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/Box2D ${PROJECT_SOURCE_DIR}/python/boxreel
          DESTINATION ${BOXREEL_PYTHON_INSTALL_DIR} COMPONENT python PATTERN __pycache__ EXCLUDE)
  install(FILES ${PROJECT_SOURCE_DIR}/python/boxreel_golden.py DESTINATION ${BOXREEL_PYTHON_INSTALL_DIR} COMPONENT python)
endif()
