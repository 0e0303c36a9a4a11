# The port of vcpkg.json beside it; untested. It builds the sources that it lies in.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DGRAZE_PAGE=OFF)
vcpkg_cmake_install()
vcpkg_copy_tools(TOOL_NAMES graze AUTO_CLEAN)
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/graze)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
