# OpenImageIO's headers and libraries, as the target OpenImageIOLibrary::OpenImageIOLibrary. Not by OpenImageIO's own config
# file: Debian 12's asks for programs and Python bindings from packages that a user of the library does not need.
find_path(OpenImageIO_INCLUDE_DIR OpenImageIO/imageio.h)
find_library(OpenImageIO_LIBRARY OpenImageIO)
find_library(OpenImageIO_Util_LIBRARY OpenImageIO_Util)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIOLibrary REQUIRED_VARS OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY
                                                                   OpenImageIO_INCLUDE_DIR)
if(OpenImageIOLibrary_FOUND AND NOT TARGET OpenImageIOLibrary::OpenImageIOLibrary)
  add_library(OpenImageIOLibrary::OpenImageIOLibrary INTERFACE IMPORTED)
  target_include_directories(OpenImageIOLibrary::OpenImageIOLibrary INTERFACE ${OpenImageIO_INCLUDE_DIR})
  target_link_libraries(OpenImageIOLibrary::OpenImageIOLibrary INTERFACE ${OpenImageIO_LIBRARY}
                                                                         ${OpenImageIO_Util_LIBRARY})
endif()
