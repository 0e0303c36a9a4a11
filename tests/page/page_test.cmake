# Runs the tests of pages in one Chromium, all or those of a file:
#   cmake [-DTEST=x_test.mjs] -DPROGRAM=.. -DCHARTS=.. -DSOURCE=.. -DSCENES=.. -DSCRATCH=.. -P ..
# Without a browser, npm or the page it is skipped; where CI is set, that is a failure.
find_program(NODE NAMES node nodejs)
find_program(NPM npm)
find_program(CHROMIUM NAMES chromium chromium-browser google-chrome)
set(missing "")
if(NOT NODE OR NOT NPM)
  set(missing "npm was not found")
elseif(NOT CHROMIUM)
  set(missing "chromium was not found")
endif()
execute_process(COMMAND ${PROGRAM} orbit ${SCENES}/05_wagg_one_mode.toml --plot ${SCRATCH}/none/x.html
  ERROR_VARIABLE answer OUTPUT_QUIET)
if(answer MATCHES "built without npm")
  set(missing "the program was built without its page")
endif()
if(missing)
  if(DEFINED ENV{CI})
    message(FATAL_ERROR "the pages cannot be tested: ${missing}")
  endif()
  message("SKIPPED: the pages were not tested: ${missing}")
  return()
endif()

file(MAKE_DIRECTORY ${SCRATCH})
file(SHA256 ${SOURCE}/package-lock.json lock)
if(NOT EXISTS ${SCRATCH}/packages_${lock})
  file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc DESTINATION ${SCRATCH})
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    WORKING_DIRECTORY ${SCRATCH} COMMAND_ERROR_IS_FATAL ANY)
  file(TOUCH ${SCRATCH}/packages_${lock})
endif()
file(GLOB modules ${SCRATCH}/*.mjs)
file(REMOVE ${modules})
file(GLOB modules ${SOURCE}/*.mjs)
file(COPY ${modules} DESTINATION ${SCRATCH})
execute_process(COMMAND ${NODE} all.mjs ${PROGRAM} ${SCENES} ${CHROMIUM} ${CHARTS} ${TEST}
  WORKING_DIRECTORY ${SCRATCH} COMMAND_ERROR_IS_FATAL ANY)
