# Run by CPack between installing and packing; see BoxreelPackage.cmake.
find_program(gzip gzip REQUIRED)

# boxreel_gzip(FILE): FILE becomes FILE.gz, with the same bytes every time.
function(boxreel_gzip file)
  execute_process(COMMAND ${gzip} -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # that of SOURCE_DATE_EPOCH when it is set
foreach(package program:boxreel development:boxreel-dev)
  string(REGEX MATCH "(.*):(.*)" matched ${package})
  set(usr ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${CMAKE_MATCH_1}/usr)
  set(docs ${usr}/share/doc/${CMAKE_MATCH_2})
  file(MAKE_DIRECTORY ${docs})
  file(COPY_FILE ${CPACK_BOXREEL_LICENCE} ${docs}/copyright)
  file(REMOVE ${docs}/LICENSE)
  file(WRITE ${docs}/changelog "boxreel (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
       "  * See CHANGELOG.md of the sources.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  boxreel_gzip(${docs}/changelog)
endforeach()
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/program/usr/share)
boxreel_gzip(${share}/man/man1/boxreel.1)
file(MAKE_DIRECTORY ${share}/zsh/vendor-completions) # zsh looks there, and not in site-functions
file(RENAME ${share}/zsh/site-functions/_boxreel ${share}/zsh/vendor-completions/_boxreel)
file(REMOVE_RECURSE ${share}/zsh/site-functions)
