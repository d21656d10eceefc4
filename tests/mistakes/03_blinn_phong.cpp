#include "tests/mistakes/building_blocks.hpp"
#include "tests/mistakes/stages.hpp"

namespace raylab::test {
namespace {

template <double (*diffuse)(double), double (*specular)(const Vec3&, const Vec3&, const Vec3&, double)>
void put_light(StageTable& table) {
  put_blinn_phong<blinn_phong_of<diffuse, specular>>(table);
}

double absolute_diffuse(double l_n) { return std::abs(l_n); }

double unweighted(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  return alpha == 0 || std::isinf(alpha) ? 0 : right_specular(l, n, v, alpha) / weight(alpha);
}
double by_mirror_direction(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot(right_reflect(-l, n), v)), alpha);
}
double half_vector_not_unit(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot((l + v) / 2.0, n)), alpha);
}
double half_vector_by_difference(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha) || l == v) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot(unit(l - v), n)), alpha);
}
double by_the_light(const Vec3& l, const Vec3& n, const Vec3&, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot(l, n)), alpha);
}
double times_alpha(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * alpha * std::max(0.0, dot(unit(l + v), n));
}
double times_the_cosine(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  return dot(l, n) * right_specular(l, n, v, alpha);
}
double no_specular(const Vec3&, const Vec3&, const Vec3&, double) { return 0; }

template <double (*weight_of)(double alpha)>
double weighted_by(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  return unweighted(l, n, v, alpha) * weight_of(alpha);
}
template <double (*weight_of)(double alpha)>
void put_weight(StageTable& table) {
  put_light<right_diffuse, weighted_by<weight_of>>(table);
  table.specular_weight = weight_of;
}
double over_100(double alpha) { return std::tanh(alpha / 200); }
double exponential_alone(double alpha) { return 1 - std::exp(-alpha / 200); }

Color weight_on_diffuse(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  return ((1 - weight(alpha)) * dot(l, n) + right_specular(l, n, v, alpha)) * (intensity * color);
}
Color white_highlight(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  return dot(l, n) * intensity * color + Color(right_specular(l, n, v, alpha) * intensity);
}

template <double (*falloff)(double r)>
void put_falloff(StageTable& table) {
  table.point_light = [](const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v,
                         const Material& material) {
    const Vec3 to_light = light.position - point;
    const double r = length(to_light);
    return blinn_phong_of<right_diffuse, right_specular>(to_light / r, n, v, light.intensity * falloff(r), material.color,
                                                         material.shininess);
  };
}
double inverse_square(double r) { return 1 / (r * r); }
double inverse_one_plus_square(double r) { return 1 / (1 + r * r); }
double inverse(double r) { return 1 / (1 + r); }
double none(double) { return 1; }

double numerator_left_out(double alpha) { return 1 / (1 + std::exp(-alpha / 200)); }
double not_divided_by_200(double alpha) { return std::tanh(alpha / 2); }
double positive_exponent(double alpha) { return (1 - std::exp(alpha / 200)) / (1 + std::exp(alpha / 200)); }

double unclamped_diffuse(double l_n) { return l_n; }
double unclamped_specular(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(dot(unit(l + v), n), alpha);
}
double specular_without_question(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot((l + v) / length(l + v), n)), alpha);
}
double specular_of_perfect_mirror(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  return alpha == 0 ? 0 : weight(alpha) * std::pow(std::max(0.0, dot(unit(l + v), n)), alpha);
}

Color weight_moved_to_diffuse(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color,
                              double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  return (weight(alpha) * dot(l, n) + unweighted(l, n, v, alpha)) * (intensity * color);
}
Color weight_on_both(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  return weight(alpha) * (dot(l, n) + unweighted(l, n, v, alpha)) * (intensity * color);
}
Color highlight_of_no_intensity(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color,
                                double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  return (dot(l, n) * intensity + right_specular(l, n, v, alpha)) * color;
}

double of_squared_distance(double r) { return inverse_square(1 + r * r); }

}  // namespace

std::vector<Mistake> mistakes_in_blinn_phong() {
  return {
      {"3.1", "shininess over 100", put_weight<over_100>},
      {"3.1", "1 - e^-x alone", put_weight<exponential_alone>},
      {"3.1", "missing minus: e^(alpha/200)", put_weight<positive_exponent>},
      {"3.1", "the numerator left out: 1/(1 + e^-x)", put_weight<numerator_left_out>},
      {"3.1", "shininess not divided by 200", put_weight<not_divided_by_200>},
      {"3.2", "no k_s", put_light<right_diffuse, unweighted>},
      {"3.2", "no specular term", put_light<right_diffuse, no_specular>},
      {"3.2", "the absolute value of L.N for the clamp", put_light<absolute_diffuse, right_specular>},
      {"3.2", "Phong's mirror direction for H", put_light<right_diffuse, by_mirror_direction>},
      {"3.2", "H not unit", put_light<right_diffuse, half_vector_not_unit>},
      {"3.2", "H from L - V", put_light<right_diffuse, half_vector_by_difference>},
      {"3.2", "L.N for H.N", put_light<right_diffuse, by_the_light>},
      {"3.2", "shininess as a factor, not a power", put_light<right_diffuse, times_alpha>},
      {"3.2", "the highlight times L.N", put_light<right_diffuse, times_the_cosine>},
      {"3.2", "1 - k_s on the diffuse term", put_blinn_phong<weight_on_diffuse>},
      {"3.2", "highlight not tinted by C", put_blinn_phong<white_highlight>},
      {"3.2", "k_s on the diffuse term, not on the highlight", put_blinn_phong<weight_moved_to_diffuse>},
      {"3.2", "k_s on the diffuse term too", put_blinn_phong<weight_on_both>},
      {"3.2", "no clamp: a light below takes light away", put_light<unclamped_diffuse, right_specular>},
      {"3.2", "highlight without the intensity", put_blinn_phong<highlight_of_no_intensity>},
      {"3.2", "a perfect mirror has a highlight", put_light<right_diffuse, specular_of_perfect_mirror>, Shows::in_unit_tests,
       "`(H.N)^inf` is 0 but in the one direction where `H.N` rounds to 1, which is no pixel"},
      {"3.2", "H.N not clamped", put_light<right_diffuse, unclamped_specular>, Shows::nowhere,
       "`H.N` has the sign of `L.N + V.N`; the contract gives `V.N >= 0`, and at `L.N <= 0` the answer is black already"},
      {"3.2", "L + V = 0 not asked for", put_light<right_diffuse, specular_without_question>, Shows::nowhere,
       "where `L = -V`, `L.N = -V.N <= 0`, and the answer is black already"},
      {"3.3", "1/r^2", put_falloff<inverse_square>},
      {"3.3", "1/(1 + r^2)", put_falloff<inverse_one_plus_square>},
      {"3.3", "1/(1 + r)", put_falloff<inverse>},
      {"3.3", "no attenuation", put_falloff<none>},
      {"3.3", "L not unit",
       [](StageTable& t) {
         t.point_light = [](const PointLight& light, const Vec3& p, const Vec3& n, const Vec3& v, const Material& m) {
           const Vec3 l = light.position - p;
           const double r = length(l);
           return blinn_phong_of<right_diffuse, right_specular>(l, n, v, light.intensity / ((1 + r) * (1 + r)), m.color,
                                                                m.shininess);
         };
       }},
      {"3.3", "the squared distance taken for the distance", put_falloff<of_squared_distance>},
      {"3.3", "the distance of the light from the origin",
       [](StageTable& t) {
         t.point_light = [](const PointLight& light, const Vec3& p, const Vec3& n, const Vec3& v, const Material& m) {
           const double r = length(light.position);
           return blinn_phong_of<right_diffuse, right_specular>(unit(light.position - p), n, v,
                                                                light.intensity / ((1 + r) * (1 + r)), m.color, m.shininess);
         };
       }},
      {"3.3", "L from the light to the point",
       [](StageTable& t) {
         t.point_light = [](const PointLight& light, const Vec3& p, const Vec3& n, const Vec3& v, const Material& m) {
           const Vec3 from_light = p - light.position;
           const double r = length(from_light);
           return blinn_phong_of<right_diffuse, right_specular>(from_light / r, n, v, light.intensity / ((1 + r) * (1 + r)),
                                                                m.color, m.shininess);
         };
       }},
      {"3.3", "N and V exchanged",
       [](StageTable& t) {
         t.point_light = [](const PointLight& light, const Vec3& p, const Vec3& n, const Vec3& v, const Material& m) {
           const Vec3 l = light.position - p;
           const double r = length(l);
           return blinn_phong_of<right_diffuse, right_specular>(l / r, v, n, light.intensity / ((1 + r) * (1 + r)), m.color,
                                                                m.shininess);
         };
       }},
      {"3.4", "direction reversed",
       [](StageTable& t) {
         t.directional_light = [](const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& m) {
           return blinn_phong_of<right_diffuse, right_specular>(unit(light.direction), n, v, light.intensity, m.color,
                                                                m.shininess);
         };
       }},
      {"3.4", "direction not unit",
       [](StageTable& t) {
         t.directional_light = [](const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& m) {
           return blinn_phong_of<right_diffuse, right_specular>(-light.direction, n, v, light.intensity, m.color,
                                                                m.shininess);
         };
       }},
      {"3.4", "weakened like a point light",
       [](StageTable& t) {
         t.directional_light = [](const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& m) {
           const double r = length(light.direction);
           return blinn_phong_of<right_diffuse, right_specular>(-unit(light.direction), n, v,
                                                                light.intensity / ((1 + r) * (1 + r)), m.color, m.shininess);
         };
       }},
      {"3.4", "N and V exchanged",
       [](StageTable& t) {
         t.directional_light = [](const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& m) {
           return blinn_phong_of<right_diffuse, right_specular>(-unit(light.direction), v, n, light.intensity, m.color,
                                                                m.shininess);
         };
       }},
      {"3.5", "no color",
       [](StageTable& t) { t.ambient_light = [](const AmbientLight& l, const Material&) { return Color(l.intensity); }; }},
      {"3.5", "no intensity",
       [](StageTable& t) { t.ambient_light = [](const AmbientLight&, const Material& m) { return m.color; }; }},
      {"3.5", "clamped",
       [](StageTable& t) {
         t.ambient_light = [](const AmbientLight& l, const Material& m) {
           return glm::min(l.intensity * m.color, Color(1));
         };
       },
       Shows::in_unit_tests, "no scene has an ambient light so bright that `I C` passes 1"},
      {"3.5", "a perfect mirror has none",
       [](StageTable& t) {
         t.ambient_light = [](const AmbientLight& l, const Material& m) {
           return std::isinf(m.shininess) ? Color(0) : l.intensity * m.color;
         };
       }},
      {"3.6", "the mean, not the sum",
       [](StageTable& t) {
         t.sum_lights = [](std::span<const Color> all) {
           Color sum(0);
           for (const Color& c : all) sum += c / static_cast<double>(all.size());
           return sum;
         };
       }},
      {"3.6", "the product, not the sum",
       [](StageTable& t) {
         t.sum_lights = [](std::span<const Color> all) {
           Color product(1);
           for (const Color& c : all) product *= c;
           return product;
         };
       }},
      {"3.6", "the last light only",
       [](StageTable& t) { t.sum_lights = [](std::span<const Color> all) { return all.empty() ? Color(0) : all.back(); }; }},
      {"3.6", "the ambient light once for each light",
       [](StageTable& t) {
         t.sum_lights = [](std::span<const Color> all) {
           Color sum(0);
           for (std::size_t k = 1; k < all.size(); ++k) sum += all[0] + all[k];
           return all.size() == 1 ? all[0] : sum;
         };
       }},
      {"3.6", "clamped",
       [](StageTable& t) {
         t.sum_lights = [](std::span<const Color> all) {
           Color sum(0);
           for (const Color& c : all) sum += c;
           return glm::min(sum, Color(1));
         };
       }},
      {"3.6", "the brightest light only",
       [](StageTable& t) {
         t.sum_lights = [](std::span<const Color> all) {
           Color brightest(0);
           for (const Color& c : all) brightest = glm::max(brightest, c);
           return brightest;
         };
       }},
  };
}

}  // namespace raylab::test
