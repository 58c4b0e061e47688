# find_package(softanvil CONFIG) defines
#
#     softanvil::softanvil   the shared library
#     softanvil::static      the static library with what it needs from the system
#
# both with the folder of softanvil.h and softanvil.hpp. The package may be moved as a whole.

get_filename_component(_softanvil_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

find_path(_softanvil_include softanvil.h PATHS "${_softanvil_prefix}/include" NO_DEFAULT_PATH NO_CACHE)
set(_softanvil_folders "${_softanvil_prefix}/lib" "${_softanvil_prefix}/lib64"
    "${_softanvil_prefix}/lib/${CMAKE_LIBRARY_ARCHITECTURE}")
find_library(_softanvil_shared NAMES libsoftanvil.so libsoftanvil.dylib libsoftanvil.dll.a softanvil.dll.lib
    PATHS ${_softanvil_folders} NO_DEFAULT_PATH NO_CACHE)
find_library(_softanvil_static NAMES libsoftanvil.a softanvil.lib
    PATHS ${_softanvil_folders} NO_DEFAULT_PATH NO_CACHE)

if(_softanvil_include AND _softanvil_shared AND NOT TARGET softanvil::softanvil)
    # The linker takes the import library on Windows and the library itself elsewhere; both are named here.
    add_library(softanvil::softanvil INTERFACE IMPORTED)
    set_target_properties(softanvil::softanvil PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${_softanvil_include}"
        INTERFACE_LINK_LIBRARIES "${_softanvil_shared}")
endif()

if(_softanvil_include AND _softanvil_static AND NOT TARGET softanvil::static)
    add_library(softanvil::static STATIC IMPORTED)
    set_target_properties(softanvil::static PROPERTIES
        IMPORTED_LOCATION "${_softanvil_static}"
        INTERFACE_INCLUDE_DIRECTORIES "${_softanvil_include}")
    if(UNIX)
        set_target_properties(softanvil::static PROPERTIES INTERFACE_LINK_LIBRARIES "pthread;${CMAKE_DL_LIBS};m")
    endif()
endif()

if(NOT TARGET softanvil::softanvil AND NOT TARGET softanvil::static)
    set(softanvil_FOUND FALSE)
    set(softanvil_NOT_FOUND_MESSAGE "no softanvil library or header under ${_softanvil_prefix}")
endif()
