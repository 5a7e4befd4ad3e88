# cmake -DPROGRAM=FILE -DLAUNCHER=FILE -DSAID=DIR -DSOURCE=DIR -DNAME=NAME -DOUTPUT=DIR -P Portable.cmake: an archive that
# runs on any Linux of this processor: the program, every library that it loads, and what loads them.
set(root ${OUTPUT}/${NAME})
file(REMOVE_RECURSE ${root})
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${PROGRAM} RESOLVED_DEPENDENCIES_VAR libraries)
file(COPY ${PROGRAM} DESTINATION ${root}/lib)
foreach(library IN LISTS libraries)
  file(COPY ${library} DESTINATION ${root}/lib FOLLOW_SYMLINK_CHAIN)
endforeach()
file(COPY_FILE ${LAUNCHER} ${root}/loadpath)
file(GLOB said ${SAID}/*)
file(COPY ${said} DESTINATION ${root}/share)
file(COPY ${SOURCE}/examples ${SOURCE}/README.md ${SOURCE}/LICENSE DESTINATION ${root})
execute_process(COMMAND strip ${root}/lib/loadpath COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E tar cJf ${NAME}.tar.xz ${NAME} WORKING_DIRECTORY ${OUTPUT}
                COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${root})
