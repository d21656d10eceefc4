#pragma once

#include "core/math/contract.hpp"
#include "core/math/lights.hpp"
#include "core/math/material.hpp"
#include "core/math/vec3.hpp"

#include <span>

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 3.1: k_s, how much a surface of this shininess (alpha >= 0, infinity allowed) mirrors: 0 for matte, 1 for a perfect
/// mirror. Handout section 4.1.
double specular_weight(double shininess);

/// Task 3.2: the light that a surface sends to the viewer, from a light of effective intensity `intensity`: Blinn-Phong.
/// l, n, v: unit vectors from the surface point to the light, along the normal, and to the viewer; n.v >= 0.
/// intensity: I >= 0, attenuated already. color: C. shininess: alpha >= 0, infinity allowed.
/// Black unless l.n > 0: a light below the surface gives neither term. The specular term is 0 where l + v is zero and at
/// infinite shininess. Not clamped. Handout section 4, equation 3, with the k_s of section 4.1.
Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess);

/// Task 3.3: a point light's part in the color at `point`, with unit normal `n` and unit vector `v` to the viewer.
/// Its intensity is I / (1 + r)^2 at distance r. Black where the light is at `point` itself. Handout sections 1 and 4.1.
Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material);

/// Task 3.4: a directional light's part in the color at a point with unit normal `n` and unit vector `v` to the viewer.
/// The light's direction may have any non-zero length. Handout sections 1 and 4.
Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material);

/// Task 3.5: an ambient light's part in the color of any point of this material: I C. Handout sections 1 and 4.1.
Color ambient_light(const AmbientLight& light, const Material& material);

/// Task 3.6: the sum of all lights' parts; black if there are none. Not clamped. Handout section 4.1.
Color sum_lights(std::span<const Color> contributions);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_03_BLINN_PHONG(TASK)                                                              \
  TASK("3.1", specular_weight, "how much a shiny surface mirrors", R"({"shininess": 100})")            \
  TASK("3.2", blinn_phong, "diffuse and specular light from one direction",                            \
       R"({"l": [0.6, 0.8, 0], "n": [0, 1, 0], "v": [-0.6, 0.8, 0], )"                                 \
       R"("intensity": 1, "color": [0.9, 0.2, 0.2], "shininess": 100})")                               \
  TASK("3.3", point_light, "a point light's part",                                                     \
       R"({"light": {"position": [0, 3, 0], "intensity": 40}, "point": [0, 0, 0], )"                   \
       R"("n": [0, 1, 0], "v": [0, 1, 0], "material": {"color": [0.9, 0.2, 0.2], "shininess": 100}})") \
  TASK("3.4", directional_light, "a directional light's part",                                         \
       R"({"light": {"direction": [0, -1, 0], "intensity": 0.6}, )"                                    \
       R"("n": [0, 1, 0], "v": [0, 1, 0], "material": {"color": [0.9, 0.2, 0.2], "shininess": 100}})") \
  TASK("3.5", ambient_light, "an ambient light's part",                                                \
       R"({"light": {"intensity": 0.1}, "material": {"color": [0.9, 0.2, 0.2]}})")                     \
  TASK("3.6", sum_lights, "all lights together", R"({"contributions": [[0.25, 0, 0], [0.5, 0.125, 0]]})")
