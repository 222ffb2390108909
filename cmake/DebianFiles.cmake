# Run by CPack once the files of the packages are laid out, before they are packed: what Debian wants
# otherwise than `cmake --install` puts it.
cmake_policy(VERSION 3.25)
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
set(source ${CMAKE_CURRENT_LIST_DIR}/..)
set(root ${CPACK_TEMPORARY_DIRECTORY})
set(program ${root}/program/usr/share)

# Debian's zsh looks for completions of packages here, and not in site-functions.
file(MAKE_DIRECTORY ${program}/zsh/vendor-completions)
file(RENAME ${program}/zsh/site-functions/_boxreel ${program}/zsh/vendor-completions/_boxreel)
file(REMOVE_RECURSE ${program}/zsh/site-functions)

# debian_compress(FILE): as Debian does it, without a time, so that the same input makes the same package.
function(debian_compress file)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
debian_compress(${program}/man/man1/boxreel.1)

# Each package has its licence and its changes.
file(READ ${source}/LICENSE licence)
file(REMOVE_RECURSE ${root}/development/usr/share/doc/boxreel)
set(packages program:boxreel development:libboxreel-dev)
if(EXISTS ${root}/python)
  list(APPEND packages python:python3-boxreel)
endif()
foreach(package IN LISTS packages)
  string(REGEX MATCH "^(.*):(.*)$" _ ${package})
  set(docs ${root}/${CMAKE_MATCH_1}/usr/share/doc/${CMAKE_MATCH_2})
  file(WRITE ${docs}/copyright "${licence}")
  file(COPY_FILE ${source}/CHANGELOG.md ${docs}/changelog)
  debian_compress(${docs}/changelog)
  file(CHMOD_RECURSE ${docs} FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
       DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()
