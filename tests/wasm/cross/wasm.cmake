# The compiler of the page's module.
include(${CMAKE_CURRENT_LIST_DIR}/../../../server/page/wasm.cmake)
