# rotorscope_precompile(TARGET HEADER...): compiles these once for all of a target, where that is wanted. Headers of ours are
# included first even where it is not.
#
# A compiler cache cannot compare what was precompiled in two trees, since it is never the same twice: beside it stands a sum of
# what went into it, which is. Headers of the system count by the versions of the compiler and of Qt.
set(precompiled_key "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_BUILD_TYPE} ${ROTORSCOPE_SANITIZE}")

# What most of our headers bring along.
set(ROTORSCOPE_STD_HEADERS <algorithm> <array> <chrono> <cstdint> <functional> <map> <memory> <optional> <span> <string> <variant>
    <vector>)

function(rotorscope_precompile target)
    set(key "${precompiled_key} Qt ${Qt6_VERSION} ${ARGN}")
    foreach(header ${ARGN})
        if(EXISTS ${header})
            file(SHA256 ${header} sum)
            string(APPEND key " ${sum}")
            set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
            if(NOT ROTORSCOPE_PCH)
                target_compile_options(${target} PRIVATE $<IF:$<BOOL:${MSVC}>,/FI,-include>${header})
            endif()
        endif()
    endforeach()
    if(ROTORSCOPE_PCH)
        target_precompile_headers(${target} PRIVATE ${ARGN})
        string(REPLACE "${PROJECT_SOURCE_DIR}" "" key "${key}")
        string(SHA256 sum "${key}")
        file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/cmake_pch.hxx.gch.sum "${sum}\n")
    endif()
endfunction()
