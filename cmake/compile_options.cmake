# raylab_options: what every target is compiled with.
add_library(raylab_options INTERFACE)
target_compile_features(raylab_options INTERFACE cxx_std_20)
target_include_directories(raylab_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_compile_options(
  raylab_options
  INTERFACE # No fused multiply-adds but those that are written: the same bits from every compiler and instruction set.
            -ffp-contract=off
            # __FILE__ as the reader knows it: stages/05_reflections/starter.cpp
            -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=
            -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            -Wsign-conversion
            # False alarms of g++ 12: wherever two strings are added (GCC bug 105329), and inside Boost.Multiprecision.
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>
            $<$<BOOL:${RAYLAB_WERROR}>:-Werror>)

# raylab_unhurried(TARGET): nothing in it runs long, and with the sanitizers' checks it takes twice as long to optimise as to compile.
function(raylab_unhurried target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O0>)
endfunction()
