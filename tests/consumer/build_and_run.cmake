# Builds the project `source`, and with it the programs of `examples`, against the package in
# `prefix`; runs all of them and gathers what they print in output.txt of the folder `build`.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${build}
    OUTPUT_VARIABLE printed ERROR_VARIABLE printed RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${code}:\n${printed}")
  endif()
  set(printed "${printed}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${build})
file(MAKE_DIRECTORY ${build})
run(${CMAKE_COMMAND} -S ${source} -B ${build} -G ${generator}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags}
  -D CMAKE_BUILD_TYPE=Release -D RMAP_EXAMPLES=${examples})
run(${CMAKE_COMMAND} --build ${build} --parallel 2)

# In the order of their names; what they print must not depend on the machine.
file(GLOB programs ${build}/consumer ${build}/examples/[0-9][0-9]_*)
list(FILTER programs EXCLUDE REGEX "\\.(rmap|txt)$")
list(LENGTH programs count)
file(GLOB sources ${examples}/[0-9][0-9]_*.cpp)
list(LENGTH sources expected)
math(EXPR expected "${expected} + 1")
if(NOT count EQUAL expected)
  message(FATAL_ERROR "${count} programs were built instead of ${expected}: ${programs}")
endif()
foreach(program IN LISTS programs)
  run(${program})
  cmake_path(GET program FILENAME name)
  file(APPEND ${build}/output.txt "== ${name}\n${printed}")
endforeach()
