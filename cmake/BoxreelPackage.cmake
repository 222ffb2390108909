# Two Debian packages, by `cmake --build BUILD --target deb` (cpack -G DEB once the program is built): `boxreel`
# is the program, its manual page and completions; `libboxreel-dev` the static libraries, headers and the
# files for CMake and pkg-config. Nobody who records films needs the second.
set(CPACK_PACKAGE_NAME boxreel)
set(CPACK_PACKAGE_VENDOR "The boxreel developers")
set(CPACK_PACKAGE_CONTACT "The boxreel developers <boxreel@users.noreply.github.com>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS # whatever the builder's umask
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/DebianFiles.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT) # NAME_VERSION_ARCHITECTURE.deb

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME boxreel)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION # the summary before it is the project's
"boxreel simulates 2D rigid bodies and makes films, pictures, figures and
approved references of what it sees, with no screen attached. The same
input gives the same bits.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)

# What is loaded when it is first needed, so that dpkg-shlibdeps cannot see it. The names of libav's packages
# hold the version of the headers compiled against (FFmpegLibrary.cpp).
set(loaded)
foreach(library avutil swscale avcodec avformat)
  file(GLOB headers ${BOXREEL_${library}_INCLUDE_DIR}/lib${library}/version*.h)
  set(major)
  string(TOUPPER ${library} LIBRARY)
  foreach(header IN LISTS headers)
    file(STRINGS ${header} lines REGEX "define +LIB${LIBRARY}_VERSION_MAJOR +[0-9]+")
    string(REGEX MATCH "[0-9]+" found "${lines}")
    string(APPEND major "${found}")
  endforeach()
  if(library MATCHES "avcodec|avformat") # Debian builds these twice, with and without GPL's encoders
    list(APPEND loaded "lib${library}${major} | lib${library}-extra${major}")
  else()
    list(APPEND loaded lib${library}${major})
  endif()
endforeach()
# libosmesa6 and EGL draw (Context.h), the latter with the drivers of libgl1-mesa-dri. Cairo and
# FreeType write PDF, and DejaVu is the one font; WebP's three write and read animations.
list(APPEND loaded libosmesa6 libegl1 libegl-mesa0 libgl1-mesa-dri libcairo2 libfreetype6 fonts-dejavu-core libwebp7 libwebpmux3 libwebpdemux2)
list(JOIN loaded ", " CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libglfw3") # the window, where there is a screen
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "bash-completion, libboxreel-dev")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libboxreel-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION 
"The libraries of boxreel for programs of one's own: an engine with the API of
the Box2D 2.3 manual, draw lists, an off-screen renderer, a recorder of films
and golden tests. For CMake and pkg-config.")
# What the static libraries link (boxreelConfig.cmake.in), and load as the program does.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libpng-dev, libimgui-dev, libstb-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "${CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libgtest-dev, boxreel")

if(TARGET boxreel_python) # a third package, for the interpreter that the module was built for
  list(APPEND CPACK_COMPONENTS_ALL python)
  string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" _ ${Python3_VERSION})
  math(EXPR next "${CMAKE_MATCH_2} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-boxreel)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"The engine by the names of the Python module of the Box2D 2.3 generation,
and films, pictures and golden tests of its worlds.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${CMAKE_MATCH_1}.${CMAKE_MATCH_2}), python3 (<< ${CMAKE_MATCH_1}.${next}), python3-numpy, ${CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pytest, boxreel")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
endif()
include(CPack)

# Without dpkg-shlibdeps CPack only warns, and leaves out the libraries that a package depends on. It also runs `file`.
add_custom_target(deb
  COMMAND sh -c "command -v dpkg-shlibdeps >/dev/null && command -v file >/dev/null || { echo 'dpkg-shlibdeps or file was not found; install them with: apt install dpkg-dev file' >&2 && exit 1; }"
  COMMAND ${CMAKE_CPACK_COMMAND} -G DEB --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake -B ${PROJECT_BINARY_DIR}
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR} USES_TERMINAL VERBATIM)
if(TARGET boxreel_python)
  add_dependencies(deb boxreel_python)
endif()
foreach(target boxreel boxreel_engine boxreel_base boxreel_drawlist boxreel_debugdraw boxreel_render boxreel_recorder
        boxreel_golden boxreel_goldenstate boxreel_goldenworld)
  add_dependencies(deb ${target})
endforeach()
