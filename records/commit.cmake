# Writes a C++ source with the commit of the working copy, and only if that changed:
#   cmake -DOUTPUT=FILE.cpp -DSOURCE=DIR -P commit.cmake
# "+changes" where tracked files differ; "unknown" where SOURCE is not itself a working copy of git.
set(commit unknown)
find_program(git git)
if(git)
  execute_process(COMMAND ${git} -C ${SOURCE} rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH ${SOURCE} here)
  if(top STREQUAL here)
    execute_process(COMMAND ${git} -C ${SOURCE} describe --always --exclude=* --abbrev=12 --dirty=+changes
      OUTPUT_VARIABLE found RESULT_VARIABLE failure OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failure AND found)
      set(commit ${found})
    endif()
  endif()
endif()
set(text "namespace wander {\nextern const char* const build_commit;\nconst char* const build_commit = \"${commit}\";\n}  // namespace wander\n")
set(before "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${OUTPUT} "${text}")
endif()
