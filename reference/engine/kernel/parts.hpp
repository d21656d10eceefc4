// The kernel: everything from a pixel's place to its color. It is one text that is compiled once for each SIMD target, with
// packs for numbers, and once for single numbers: in a namespace RAYLAB_TARGET of its own each time, so that the program
// holds all of them. So these headers have no include guards and include nothing: what they need, and what they are to be
// called, the two files say that include this one. Each stands here behind those that it needs.
//
// What every pack comes by is compiled into few functions, RAYLAB_INLINE: the search for the nearest surface into that for a
// bounce, a tile into that for rows. Around a call all registers go to memory: with calls there it took 8 % more
// instructions. What few packs come by is [[gnu::noinline]].

// clang-format off
#include "reference/engine/kernel/scalar.hpp"
#ifdef RAYLAB_PACKS
#include "reference/engine/kernel/pack.hpp"
#include "reference/engine/kernel/twin.hpp"
#endif
#include "reference/engine/kernel/vec3.hpp"

#include "reference/engine/kernel/exact.hpp"
#include "reference/engine/kernel/intersect.hpp"
#include "reference/engine/kernel/power.hpp"
#include "reference/engine/kernel/glass.hpp"

#include "reference/engine/kernel/search.hpp"
#include "reference/engine/kernel/ray.hpp"
#include "reference/engine/kernel/beam.hpp"
#include "reference/engine/kernel/surface.hpp"

#include "reference/engine/kernel/sphere_search.hpp"
#include "reference/engine/kernel/nearest.hpp"
#include "reference/engine/kernel/shadow.hpp"
#include "reference/engine/kernel/light.hpp"
#include "reference/engine/kernel/tracer.hpp"
#include "reference/engine/kernel/sampler.hpp"
