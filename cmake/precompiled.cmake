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

# rotorscope_batch(TARGET [NAME]): compiles the files of a folder, with a NAME all of the target, in batches, so that what they
# include is read once a batch. In exchange the files of a folder share what they keep to themselves: of two things in unnamed
# namespaces each has a name of its own, or both files use one. Since that holds for a folder, it does not matter where a batch
# ends. Call it behind the last source.
function(rotorscope_batch target)
    if(ROTORSCOPE_BATCH LESS 2)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source ${sources})
        set(folder ${ARGN})
        if(NOT folder)
            cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE folder)
            cmake_path(GET folder PARENT_PATH folder)
            cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
        endif()
        string(MAKE_C_IDENTIFIER "${folder}" group)
        list(APPEND files_${group} "${source}")
        list(LENGTH files_${group} count)
        math(EXPR batch "(${count} - 1) / ${ROTORSCOPE_BATCH}")
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${batch})
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # g++ takes what a class of a batched file has of an unnamed namespace for something that others include.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()
