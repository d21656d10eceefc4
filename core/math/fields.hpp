#pragma once

/// The one list of a plain struct's fields, written once below the struct, for whatever prints, compares or records
/// calls of tasks.
///
///     struct Sphere { Vec3 center; double radius; };
///     RAYLAB_FIELDS(Sphere, RAYLAB_FIELD(center) RAYLAB_FIELD(radius))
///
/// gives `for_each_field(sphere, visit)`, which calls `visit("center", sphere.center)` and so on, in that order.
#define RAYLAB_FIELDS(Type, fields)                                  \
  template <class Visit>                                             \
  constexpr void for_each_field(const Type& object, Visit&& visit) { \
    fields                                                           \
  }
#define RAYLAB_FIELD(name) visit(#name, object.name);
