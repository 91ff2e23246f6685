# find_package(tanglefree CONFIG) gives three targets:
#
#     tanglefree::tanglefree   the shared library
#     tanglefree::static       the archive
#     tanglefree::threads      the pool of threads, to be linked besides
#
# Nothing here depends on where it was installed.
get_filename_component(_tanglefree "${CMAKE_CURRENT_LIST_DIR}" REALPATH)
get_filename_component(_tanglefree "${_tanglefree}/../../.." ABSOLUTE)

if(NOT TARGET tanglefree::tanglefree)
  add_library(tanglefree::tanglefree SHARED IMPORTED)
  set_target_properties(tanglefree::tanglefree PROPERTIES
    IMPORTED_LOCATION "${_tanglefree}/lib/libtanglefree.so"
    INTERFACE_INCLUDE_DIRECTORIES "${_tanglefree}/include")

  add_library(tanglefree::static STATIC IMPORTED)
  set_target_properties(tanglefree::static PROPERTIES
    IMPORTED_LOCATION "${_tanglefree}/lib/libtanglefree.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_tanglefree}/include"
    INTERFACE_LINK_LIBRARIES m)

  add_library(tanglefree::threads STATIC IMPORTED)
  set_target_properties(tanglefree::threads PROPERTIES
    IMPORTED_LOCATION "${_tanglefree}/lib/libtanglefree_threads.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_tanglefree}/include"
    INTERFACE_COMPILE_OPTIONS -pthread
    INTERFACE_LINK_LIBRARIES "-pthread;m")
endif()

unset(_tanglefree)
