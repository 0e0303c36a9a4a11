# The page of --plot x.html, bundled at build time and compiled into the program. Only this needs npm
# and, the first time, its registry; without npm the program is built without the page and says so.
option(GRAZE_PAGE "Build the page of --plot x.html into the program (needs npm)" ON)
find_program(GRAZE_NPM npm)
find_program(GRAZE_NODE NAMES node nodejs)

set(page_source ${CMAKE_CURRENT_BINARY_DIR}/page_template.cpp)
if(GRAZE_PAGE AND GRAZE_NPM AND GRAZE_NODE)
  set(page_folder ${PROJECT_BINARY_DIR}/page)
  file(GLOB page_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.js
       ${CMAKE_CURRENT_LIST_DIR}/*.mjs ${CMAKE_CURRENT_LIST_DIR}/*.html
       ${CMAKE_CURRENT_LIST_DIR}/*.css)
  set(page_packages ${CMAKE_CURRENT_LIST_DIR}/package.json
      ${CMAKE_CURRENT_LIST_DIR}/package-lock.json ${CMAKE_CURRENT_LIST_DIR}/.npmrc)
  file(MAKE_DIRECTORY ${page_folder})
  # No package's own scripts are run.
  add_custom_command(OUTPUT ${page_folder}/packages
    COMMAND ${CMAKE_COMMAND} -E copy ${page_packages} ${page_folder}
    COMMAND ${GRAZE_NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error > npm.log
    COMMAND ${CMAKE_COMMAND} -E touch packages
    DEPENDS ${page_packages} WORKING_DIRECTORY ${page_folder} VERBATIM
    COMMENT "Fetching the packages of the page (without network: -DGRAZE_PAGE=OFF)")
  add_custom_command(OUTPUT ${page_source}
    COMMAND ${CMAKE_COMMAND} -E copy ${page_files} ${page_folder}
    COMMAND ${GRAZE_NODE} bundle.mjs ${page_source}
    DEPENDS ${page_folder}/packages ${page_files} WORKING_DIRECTORY ${page_folder} VERBATIM
    COMMENT "Bundling the page")
else()
  if(GRAZE_PAGE)
    message(STATUS "npm was not found: --plot x.html will not be available")
  endif()
  file(CONFIGURE OUTPUT ${page_source} CONTENT [[
#include "graze/report/page/detail/page_template.hpp"

namespace graze {
std::string_view page_template() { return {}; }
}  // namespace graze
]])
endif()
target_sources(graze_report PRIVATE ${page_source})
