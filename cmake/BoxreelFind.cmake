# What is missing is named with the package that brings it, in one sentence.

# boxreel_find_package(NAME PACKAGE [VERSION]): find_package that stops so.
function(boxreel_find_package name package)
  find_package(${name} ${ARGN} QUIET GLOBAL)
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "boxreel needs ${name}, which was not found; install it with: apt install ${package}")
  endif()
endfunction()

# boxreel_find_header(VARIABLE HEADER PACKAGE [ARGUMENT …]): the folder of a header whose library is loaded at run
# time; the arguments are those of find_path.
function(boxreel_find_header variable header package)
  find_path(${variable} ${header} ${ARGN} DOC "Where ${header} is (Debian: ${package})")
  mark_as_advanced(${variable})
  if(NOT ${variable})
    message(FATAL_ERROR "boxreel needs the header ${header}, which was not found; install it with: apt install ${package}")
  endif()
endfunction()
