# Runs at every build: writes build_info.cc anew if the commit or its state has changed.
# In: MDA_SOURCE, MDA_TEMPLATE, MDA_OUTPUT and the values that the template names.
set(MDA_COMMIT unknown)
set(MDA_DIRTY false)
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${MDA_SOURCE} rev-parse HEAD
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(MDA_COMMIT ${commit})
    execute_process(COMMAND ${GIT} -C ${MDA_SOURCE} status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      set(MDA_DIRTY true)
    endif()
  endif()
endif()
configure_file(${MDA_TEMPLATE} ${MDA_OUTPUT} @ONLY)
