# libmatio, which reads and writes the files of MATLAB: the target MATIO::headers. The library itself is loaded when it is
# needed (core/session/files/mat_library.cpp), by the version of its interface that these headers belong to.
find_path(MATIO_INCLUDE_DIR matio.h)
find_library(MATIO_LIBRARY matio)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MATIO REQUIRED_VARS MATIO_LIBRARY MATIO_INCLUDE_DIR)
mark_as_advanced(MATIO_INCLUDE_DIR MATIO_LIBRARY)
if(MATIO_FOUND AND NOT TARGET MATIO::headers)
    add_library(MATIO::headers INTERFACE IMPORTED)
    set_target_properties(MATIO::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${MATIO_INCLUDE_DIR})
    file(REAL_PATH ${MATIO_LIBRARY} matio_file)
    if(matio_file MATCHES "libmatio\\.so\\.([0-9]+)")
        set_target_properties(MATIO::headers PROPERTIES
            INTERFACE_COMPILE_DEFINITIONS ROTORSCOPE_MATIO_ABI=${CMAKE_MATCH_1})
    endif()
endif()
