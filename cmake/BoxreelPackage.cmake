# Debian packages: `cpack -G DEB` in the build's folder. boxreel has the program, boxreel-dev the
# libraries for programs of others. What the program links dpkg-shlibdeps finds; what it loads when it
# needs it (libav, OSMesa, Cairo, …) is named here.
if(NOT PROJECT_IS_TOP_LEVEL OR NOT TARGET boxreel)
  return() # a subproject leaves its parent's packages alone
endif()

# boxreel_soname(VARIABLE LIBRARY): the major version of the libav library whose headers are compiled.
function(boxreel_soname variable library)
  string(TOUPPER ${library} upper)
  foreach(header version_major.h version.h)
    set(file ${BOXREEL_${library}_INCLUDE_DIR}/lib${library}/${header})
    if(EXISTS ${file})
      file(STRINGS ${file} line REGEX "#define LIB${upper}_VERSION_MAJOR +[0-9]+")
      if(line MATCHES "([0-9]+)$")
        set(${variable} lib${library}${CMAKE_MATCH_1} PARENT_SCOPE)
        return()
      endif()
    endif()
  endforeach()
endfunction()

set(BOXREEL_LOADED libosmesa6 libwebp7 libwebpmux3 libwebpdemux2 libcairo2 libfreetype6 fonts-dejavu-core)
foreach(library avcodec avformat avutil swscale)
  boxreel_soname(package ${library})
  list(APPEND BOXREEL_LOADED ${package})
endforeach()
list(SORT BOXREEL_LOADED)
list(JOIN BOXREEL_LOADED ", " BOXREEL_LOADED)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME boxreel)
set(CPACK_PACKAGE_VENDOR "The boxreel authors")
set(BOXREEL_PACKAGE_CONTACT "boxreel maintainers <boxreel@example.org>" CACHE STRING
    "Who answers for the Debian packages: name and address")
set(CPACK_PACKAGE_CONTACT "${BOXREEL_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME boxreel)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${BOXREEL_LOADED}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libglfw3, libegl1, libegl-mesa0")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"Simulates worlds with the API of the Box2D 2.3 manual and makes films,
pictures and figures of them without a display, and compares them with
approved ones.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME boxreel-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "libpng-dev, libimgui-dev, libstb-dev, zlib1g-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"The engine, the draw list, the renderer, the recorder and golden tests as
static libraries, for CMake's find_package and for pkg-config.")

# What Debian wants elsewhere, or in another form, than an installation has it.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/BoxreelDebianFiles.cmake)
set(CPACK_BOXREEL_LICENCE ${PROJECT_SOURCE_DIR}/LICENSE)
include(CPack)
