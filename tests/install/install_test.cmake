# SPDX-License-Identifier: MIT
# Installs a build tree into a new prefix, then configures, builds and runs a program that knows
# nothing but that prefix. Variables: BUILD, WORK, CONSUMER, COMPILER, FLAGS, EXPECT.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
                    ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${ARGN} failed (${status}):\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${WORK}/prefix/bin/cobble --version)
message(STATUS "installed program: ${output}")
run(${CMAKE_COMMAND} -G Ninja -S ${CONSUMER} -B ${WORK}/build
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER}
    "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
if(NOT output STREQUAL "${EXPECT}\n")
    message(FATAL_ERROR "the consumer printed '${output}', not '${EXPECT}'")
endif()
# The next run starts from nothing again; what is left would only take space.
file(REMOVE_RECURSE ${WORK})
