# Cross-compiling with zig (its Clang, libc++ and each target's C library). CROMER_TARGET is zig's name of the target, for instance
# aarch64-linux-gnu.2.28; CROMER_ZIG names the program.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CROMER_TARGET CROMER_ZIG CROMER_WRAPPERS)
string(REGEX MATCH "^([a-z0-9_]+)-([a-z]+)" found "${CROMER_TARGET}")
set(CMAKE_SYSTEM_PROCESSOR ${CMAKE_MATCH_1})
if(CMAKE_MATCH_2 STREQUAL windows)
  set(CMAKE_SYSTEM_NAME Windows)
elseif(CMAKE_MATCH_2 STREQUAL macos)
  set(CMAKE_SYSTEM_NAME Darwin)
else()
  set(CMAKE_SYSTEM_NAME Linux)
endif()
set(CMAKE_SYSTEM_VERSION 1)

# CMake wants programs of one word.
foreach(tool cc c++ ar ranlib)
  set(file ${CROMER_WRAPPERS}/${CROMER_TARGET}-${tool})
  if(NOT EXISTS ${file})
    set(target)
    if(tool MATCHES "^c")
      set(target "-target ${CROMER_TARGET}")
      if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
        string(APPEND target " -mcpu=x86_64")
      endif()
    endif()
    file(WRITE ${file} "#!/bin/sh\nexec ${CROMER_ZIG} ${tool} ${target} \"$@\"\n")
    file(CHMOD ${file} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endif()
endforeach()
# `windres -O coff OPTIONS SOURCE OBJECT`, as CMake calls it.
set(file ${CROMER_WRAPPERS}/windres)
if(NOT EXISTS ${file})
  file(WRITE ${file} [[#!/bin/sh
options=
while [ $# -gt 2 ]; do
  case $1 in
    -O) shift ;;
    *) options="$options $1" ;;
  esac
  shift
done
]] "exec ${CROMER_ZIG} rc /:output-format coff $options /fo \"$2\" -- \"$1\"\n")
  file(CHMOD ${file} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endif()
set(CMAKE_RC_COMPILER ${file})
set(CMAKE_C_COMPILER ${CROMER_WRAPPERS}/${CROMER_TARGET}-cc)
set(CMAKE_CXX_COMPILER ${CROMER_WRAPPERS}/${CROMER_TARGET}-c++)
set(CMAKE_AR ${CROMER_WRAPPERS}/${CROMER_TARGET}-ar)
set(CMAKE_RANLIB ${CROMER_WRAPPERS}/${CROMER_TARGET}-ranlib)

# Nothing of this machine's own.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# CMake asks for it; nothing here is installed.
set(CMAKE_INSTALL_NAME_TOOL true)

# Without the names that only a debugger reads.
set(CMAKE_EXE_LINKER_FLAGS_INIT -s)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -s)
