#pragma once

namespace raylab {

/// A field of a plain struct, as `for_each_field` names it.
struct Field {
  const char* name;
  bool optional;  ///< may be left out where the struct is written down; the struct's own default is meant then
};

}  // namespace raylab

/// The one list of a plain struct's fields, written once below the struct, for whatever prints, reads, compares or records
/// calls of tasks.
///
///     struct Sphere { Vec3 center; double radius; };
///     RAYLAB_FIELDS(Sphere, RAYLAB_FIELD(center) RAYLAB_FIELD(radius))
///
/// gives `for_each_field(sphere, visit)`, which calls `visit(Field{"center", false}, sphere.center)` and so on, in that
/// order; the values of a sphere that is not const can be set. RAYLAB_OPTIONAL_FIELD is for a field that may be left out:
/// what a scene file may leave out, and what a default says as well (a ray leaves nothing).
#define RAYLAB_FIELDS(Type, fields)                                  \
  template <class Visit>                                             \
  constexpr void for_each_field(const Type& object, Visit&& visit) { \
    fields                                                           \
  }                                                                  \
  template <class Visit>                                             \
  constexpr void for_each_field(Type& object, Visit&& visit) {       \
    fields                                                           \
  }
#define RAYLAB_FIELD(name) visit(::raylab::Field{#name, false}, object.name);
#define RAYLAB_OPTIONAL_FIELD(name) visit(::raylab::Field{#name, true}, object.name);

/// The names of an enum's values, written once below the enum:
///
///     enum class Side { outwards, inwards };
///     RAYLAB_NAMES(Side, RAYLAB_NAME(outwards) RAYLAB_NAME(inwards))
///
/// gives `for_each_name(Side{}, visit)`, which calls `visit("outwards", Side::outwards)` and so on.
#define RAYLAB_NAMES(Type, names)                     \
  template <class Visit>                              \
  constexpr void for_each_name(Type, Visit&& visit) { \
    using Enum = Type;                                \
    names                                             \
  }
#define RAYLAB_NAME(name) visit(#name, Enum::name);
