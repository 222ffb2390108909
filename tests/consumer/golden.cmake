# Somebody else's project with golden tests of its own: missing, accepted, passed, in shards, and failed
# after a planted change.
include("${CMAKE_CURRENT_LIST_DIR}/Steps.cmake")
set(prefix "${WORK_DIR}/prefix")
set(project "${WORK_DIR}/project")
set(build "${WORK_DIR}/build")
set(references "${project}/references")
set(tests "${build}/seesaw_tests")
set(environment "${CMAKE_COMMAND}" -E env --unset=BOXREEL_GOLDEN_ACCEPT --unset=CI)
set(ctest ${environment} "${CTEST}" --test-dir "${build}" --output-on-failure)
set(program ${environment} --unset=DASHBOARD_TEST_FROM_CTEST --unset=CTEST_INTERACTIVE_DEBUG_MODE
    BOXREEL_GOLDEN_OUTPUT=${WORK_DIR}/failures)

step("installing" COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/project" DESTINATION "${WORK_DIR}")
step("configuring" COMMAND "${CMAKE_COMMAND}" ${compiler} -S "${project}" -B "${build}" -DCMAKE_PREFIX_PATH=${prefix})
step("building" COMMAND "${CMAKE_COMMAND}" --build "${build}")

step("without references" FAILS OUTPUT said COMMAND ${ctest})
expect_text("${said}" "seesaw/1s: there is no reference" "BOXREEL_GOLDEN_ACCEPT=missing" "0% tests passed, 3 tests failed")
step("accepting" OUTPUT said COMMAND ${program} BOXREEL_GOLDEN_ACCEPT=missing "${tests}")
expect_text("${said}" "accepted  seesaw/1s: there was no reference." "accepted  meter/half")
expect_file("${references}/state/seesaw/1s.txt" "${references}/frames/seesaw/1.5s.png" "${references}/frames/meter/half.png")
step("with references" OUTPUT said COMMAND ${ctest})
expect_text("${said}" "100% tests passed, 0 tests failed out of 3")
# The installed program makes a page of what they left.
set(makePage "${prefix}/bin/boxreel" golden report)
step("reporting that all passed" OUTPUT said COMMAND ${makePage} "${build}/golden-output")
expect_text("${said}" "4 moments: all as approved")
file(RENAME "${references}" "${WORK_DIR}/elsewhere")
step("with references elsewhere" COMMAND ${program} BOXREEL_GOLDEN_REFERENCES=${WORK_DIR}/elsewhere "${tests}")
step("without them" FAILS COMMAND ${program} "${tests}")
file(RENAME "${WORK_DIR}/elsewhere" "${references}")

# Two shards run all, each its own.
set(ran 0)
foreach(shard 0 1)
  step("shard ${shard}" OUTPUT said COMMAND ${program} GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=${shard} "${tests}")
  if(NOT said MATCHES "([0-9]+) tests? from [0-9]+ test suites? ran")
    message(FATAL_ERROR "shard ${shard} does not say what it ran:\n${said}")
  endif()
  if(CMAKE_MATCH_1 EQUAL 0 OR CMAKE_MATCH_1 EQUAL 3)
    message(FATAL_ERROR "shard ${shard} of 2 ran ${CMAKE_MATCH_1} of 3 tests")
  endif()
  math(EXPR ran "${ran} + ${CMAKE_MATCH_1}")
endforeach()
if(NOT ran EQUAL 3)
  message(FATAL_ERROR "two shards ran ${ran} of 3 tests")
endif()

# Heavier boxes: another motion. A darker meter: other pixels.
replace_in("${project}/Seesaw.cpp" "AddBox(world, 4.0f, 5.0f" "AddBox(world, 4.0f, 5.1f")
replace_in("${project}/SeesawTest.cpp" "200 : 40" "190 : 40")
step("building again" COMMAND "${CMAKE_COMMAND}" --build "${build}")
step("after a planted change" FAILS OUTPUT said COMMAND ${ctest} -T Test --no-compress-output)
expect_text("${said}" "seesaw/1s: the worlds differ" "seesaw/10s: the worlds differ" "meter/half: other pixels"
  "BOXREEL_GOLDEN_ACCEPT=changed" "0% tests passed, 3 tests failed")
set(output "${build}/golden-output")
foreach(name seesaw/1s seesaw/1.5s meter/half)
  foreach(picture expected actual difference side-by-side)
    expect_file("${output}/${name}.${picture}.png")
  endforeach()
endforeach()
step("reporting the change" OUTPUT said COMMAND ${makePage} "${build}/golden-output" -o "${WORK_DIR}/report.html")
expect_text("${said}" "4 moments: 4 not as approved")
file(READ "${WORK_DIR}/report.html" page)
expect_text("${page}" "id=\"seesaw/1s\"" "id=\"meter/half\"" "\"actualPicture\":\"data:image/png;base64,")
# What CTest sends to CDash has the pictures in it.
file(GLOB report "${build}/Testing/*/Test.xml")
file(READ "${report}" report)
expect_text("${report}" "type=\"image/png\"" "name=\"TestImage\"" "name=\"ValidImage\"" "name=\"DifferenceImage2\""
  "name=\"SideBySide\"")
step("outside CTest" FAILS OUTPUT said COMMAND ${program} "${tests}")
if(said MATCHES "CTestMeasurement")
  message(FATAL_ERROR "a person at a terminal is shown lines for CTest:\n${said}")
endif()

# Failures of two shards lie in two folders.
foreach(shard 0 1)
  step("failing shard ${shard}" FAILS COMMAND ${program} GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=${shard} "${tests}")
  file(GLOB_RECURSE pictures "${WORK_DIR}/failures/shard-${shard}-of-2/*.side-by-side.png")
  if(NOT pictures)
    message(FATAL_ERROR "shard ${shard} left no picture")
  endif()
endforeach()

step("reporting both shards" OUTPUT said COMMAND ${makePage} "${WORK_DIR}/failures/shard-0-of-2"
  "${WORK_DIR}/failures/shard-1-of-2" -o "${WORK_DIR}/shards.html")
expect_text("${said}" "4 moments: 4 not as approved")

step("accepting the change" COMMAND ${program} BOXREEL_GOLDEN_ACCEPT=changed "${tests}")
step("with the new references" COMMAND ${ctest})
