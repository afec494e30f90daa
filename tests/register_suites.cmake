# cmake -DPROGRAM=... -DLABEL=quick|long -DOUTPUT=... -P: writes the tests of a program for CTest.
# Quick ones are one of each suite: its tests share what is made once, and a process starts once.
# Large suites are cut in parts, so that all cores have work to the end.  Long ones are each for itself.
if(LABEL STREQUAL long)
  set(part_size 1)
else()
  set(part_size 16)
endif()

execute_process(COMMAND ${PROGRAM} --gtest_list_tests
  OUTPUT_VARIABLE lines RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${result}\n${lines}")
endif()

set(script "")
function(register NAME FILTER)
  string(APPEND script
    "add_test([==[${NAME}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${FILTER}]==])\n"
    "set_tests_properties([==[${NAME}]==] PROPERTIES LABELS ${LABEL}\n"
    # Skipped is a suite of which no test could run; a failure's line would be the last.
    [==[  SKIP_REGULAR_EXPRESSION "PASSED  \\] 0 tests.*SKIPPED \\] [^\n]*\n$")]==] "\n")
  set(script "${script}" PARENT_SCOPE)
endfunction()

# Of `suite`, what `tests` names.
function(register_suite)
  list(LENGTH tests count)
  if(part_size EQUAL 1)
    foreach(test IN LISTS tests)
      register("${suite}.${test}" "${suite}.${test}")
    endforeach()
  elseif(count LESS_EQUAL part_size)
    register("${suite}" "${suite}.*")
  else()
    set(part 1)
    math(EXPR last "${count} - 1")
    foreach(begin RANGE 0 ${last} ${part_size})
      list(SUBLIST tests ${begin} ${part_size} some)
      list(TRANSFORM some PREPEND "${suite}.")
      list(JOIN some ":" filter)
      register("${suite}.part${part}" "${filter}")
      math(EXPR part "${part} + 1")
    endforeach()
  endif()
  set(script "${script}" PARENT_SCOPE)
endfunction()

# `Suite.` or `  Test`, a comment behind either.
string(REGEX REPLACE "[;#][^\n]*" "" lines "${lines}")
string(REGEX REPLACE "[][]" "" lines "${lines}")
string(REPLACE "\n" ";" lines "${lines}")
set(suite "")
set(tests "")
foreach(line IN LISTS lines)
  if(line MATCHES "^  ([^ ]+)")
    list(APPEND tests "${CMAKE_MATCH_1}")
  elseif(line MATCHES "^([^ ]+)\\. *$")
    set(next ${CMAKE_MATCH_1})
    if(tests)
      register_suite()
    endif()
    set(suite ${next})
    set(tests "")
  endif()
endforeach()
if(tests)
  register_suite()
endif()
file(WRITE ${OUTPUT} "${script}")
