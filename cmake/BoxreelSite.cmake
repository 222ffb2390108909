# The documentation as pages: `api` (Doxygen) and `site` (MkDocs with its theme Material, the API where there is a
# Doxygen, and pages that play scenes). Missing programs are reported when a target is built, not before. A public name
# without a comment fails `api`, as any other warning of Doxygen's does.
find_program(BOXREEL_DOXYGEN doxygen DOC "Makes the API reference (Debian: doxygen)")
find_program(BOXREEL_MKDOCS mkdocs DOC "Makes the site (Debian: mkdocs and mkdocs-material)")
find_program(BOXREEL_SITE_PYTHON python3 DOC "Puts the site together (Debian: python3)")
mark_as_advanced(BOXREEL_DOXYGEN BOXREEL_MKDOCS BOXREEL_SITE_PYTHON)
set(BOXREEL_SITE_DIR ${PROJECT_BINARY_DIR}/site)

# boxreel_missing(TARGET PACKAGE): a target that only says what to install.
function(boxreel_missing target package)
  add_custom_target(${target} COMMAND ${CMAKE_COMMAND} -E echo
    "The target ${target} needs ${package}, which was not found; install it with: apt install ${package}"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endfunction()

if(BOXREEL_DOXYGEN)
  set(API_INPUT engine base debugdraw render recorder golden)
  list(TRANSFORM API_INPUT REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1/include")
  list(JOIN API_INPUT " " API_INPUT)
  file(MAKE_DIRECTORY ${BOXREEL_SITE_DIR})
  configure_file(${PROJECT_SOURCE_DIR}/docs/site/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
  add_custom_target(api COMMAND ${BOXREEL_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile VERBATIM)
else()
  boxreel_missing(api doxygen)
endif()
if(NOT BOXREEL_MKDOCS)
  boxreel_missing(site "mkdocs mkdocs-material")
elseif(NOT BOXREEL_SITE_PYTHON)
  boxreel_missing(site python3)
elseif(TARGET boxreel) # which makes the pages that play
  add_custom_target(site
    COMMAND ${BOXREEL_SITE_PYTHON} ${PROJECT_SOURCE_DIR}/docs/site/site.py ${PROJECT_SOURCE_DIR} ${BOXREEL_SITE_DIR}
      $<TARGET_FILE:boxreel> VERBATIM)
  if(BOXREEL_DOXYGEN)
    add_dependencies(site api)
  endif()
endif()
