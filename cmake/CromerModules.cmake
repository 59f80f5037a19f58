# What is loaded only when it is needed: HDF5 and MPI take milliseconds to start. Without them cromer is built
# all the same and says what is missing when it is asked for.

# cromer_module(<name> <targets>): libcromer_<name>.so of src/cromer/cluster/modules/<name>.cpp, beside the program.
function(cromer_module name)
  add_library(cromer_module_${name} MODULE ${PROJECT_SOURCE_DIR}/src/cromer/cluster/modules/${name}.cpp)
  set_target_properties(cromer_module_${name} PROPERTIES OUTPUT_NAME cromer_${name}
                        LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  target_include_directories(cromer_module_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(cromer_module_${name} PRIVATE cromer_flags ${ARGN})
  target_link_options(cromer_module_${name} PRIVATE -Wl,--as-needed)
  install(TARGETS cromer_module_${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/cromer COMPONENT cluster)
endfunction()

# The serial flavour: one process writes.
function(cromer_find_hdf5)
  find_path(CROMER_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial)
  find_library(CROMER_HDF5_LIBRARY NAMES hdf5_serial hdf5 PATH_SUFFIXES hdf5/serial)
  if(CROMER_HDF5_INCLUDE AND CROMER_HDF5_LIBRARY)
    add_library(cromer_hdf5_library INTERFACE)
    target_include_directories(cromer_hdf5_library SYSTEM INTERFACE ${CROMER_HDF5_INCLUDE})
    target_link_libraries(cromer_hdf5_library INTERFACE ${CROMER_HDF5_LIBRARY})
  endif()
endfunction()

macro(cromer_modules)
  cromer_find_hdf5()
  if(TARGET cromer_hdf5_library)
    cromer_module(hdf5 cromer_hdf5_library)
  else()
    message(STATUS "No HDF5 (libhdf5-dev): cromer is built without .h5 files")
  endif()
  set(MPI_CXX_SKIP_MPICXX ON)
  find_package(MPI COMPONENTS CXX)
  if(MPI_CXX_FOUND)
    cromer_module(mpi MPI::MPI_CXX)
  else()
    message(STATUS "No MPI (libopenmpi-dev): cromer is built without ranks")
  endif()
endmacro()
