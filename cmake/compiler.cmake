# What every target is compiled with: the language, the warnings, the sanitizers and the compiler cache.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
        CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_PCH_EXTSUM=1
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()

add_library(rotorscope_options INTERFACE)
if(MSVC)
    target_compile_options(rotorscope_options INTERFACE /W4 /utf-8 /permissive- $<$<BOOL:${ROTORSCOPE_WERROR}>:/WX>)
    target_compile_definitions(rotorscope_options INTERFACE NOMINMAX)
else()
    target_compile_options(rotorscope_options INTERFACE
        -Wall -Wextra -Wpedantic -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual -Wformat=2
        # In a batch a local name would hide that of another file. `./dev lint` compiles each file by itself.
        $<IF:$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<EQUAL:${ROTORSCOPE_BATCH},1>>>,-Wshadow=local,-Wshadow>
        $<$<BOOL:${ROTORSCOPE_WERROR}>:-Werror>
        # g++ 12 at -O3 takes the growth of a std::vector for an overflow, and what an empty std::optional or another part of a
        # std::variant would hold for used; what it says at -O1 counts.
        $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-stringop-overflow -Wno-array-bounds -Wno-maybe-uninitialized -Wno-restrict>)
endif()

# rotorscope_unhurried(TARGET): its code waits for people and for the line all its time; a third of the compiler's seconds are saved.
function(rotorscope_unhurried target)
    if(NOT MSVC)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
endfunction()

# rotorscope_transforms(FILE...): files that transform samples. g++ 12 packs the complex numbers of kissfft in twos, and moves them
# about so much for it that a third of the time is lost. A file with options of its own is in no batch.
function(rotorscope_transforms)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON
        COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
endfunction()

if(NOT MSVC) # what Debian's own packages are hardened with
    add_compile_options($<$<CONFIG:Release>:-fstack-protector-strong> $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=2>)
    if(UNIX AND NOT APPLE)
        add_link_options($<$<CONFIG:Release>:-Wl,-z,relro,-z,now>)
    endif()
endif()

if(ROTORSCOPE_SANITIZE)
    # Global, so that the static libraries, the tests and the programs agree.
    add_compile_options(-fsanitize=${ROTORSCOPE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
    add_link_options(-fsanitize=${ROTORSCOPE_SANITIZE})
endif()

if(ROTORSCOPE_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
    if(ROTORSCOPE_FUZZ_FAST)
        # Half of the time went into writing down comparisons; a script of acts is found without them.
        add_compile_options(-fno-sanitize-coverage=trace-cmp,indirect-calls)
    else()
        add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
        add_link_options(-fsanitize=address,undefined)
    endif()
endif()
