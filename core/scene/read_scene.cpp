#include "core/scene/read_scene.hpp"

#include "core/scene/read_cloud.hpp"
#include "core/scene/read_file.hpp"
#include "core/scene/read_section.hpp"
#include "core/scene/read_toml.hpp"
#include "core/scene/read_warnings.hpp"

#include <cstdint>
#include <string>
#include <utility>

namespace raylab {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_scene_bytes = 16U << 20U;  // 150,000 spheres; more belong in a cloud
constexpr std::uintmax_t most_cloud_bytes = 1U << 30U;   // ten million spheres of 100 bytes

void read_camera(Section& section, Camera& camera) {
  section.vector("position", Need::required, camera.position, coordinate_rules);
  const bool facing = section.direction("facing", Need::required, camera.facing);
  const bool up = section.direction("up", Need::required, camera.up);
  section.number("half_field_of_view", Need::optional, camera.half_field_of_view, field_of_view_rules);
  section.finish();
  if (facing && up && length(cross(unit(camera.facing), unit(camera.up))) <= 1e-12) {
    section.error("up", "must not be parallel to facing, nor opposite to it");
  }
}

void read_image(Section& section, ImageSize& image) {
  section.whole("width", Need::optional, image.width, 1, 65536);
  section.whole("height", Need::optional, image.height, 1, 65536);
  section.finish();
}

void read_surface(Section& section, Material& material) {
  section.vector("color", Need::required, material.color, color_rules);
  section.number("shininess", Need::optional, material.shininess, shininess_rules);
}

void read_plane(Section& section, PlaneObject& plane) {
  section.vector("point", Need::required, plane.shape.point, coordinate_rules);
  section.direction("normal", Need::required, plane.shape.normal);
  read_surface(section, plane.material);
  section.finish();
}

void read_sphere(Section& section, SphereObject& sphere) {
  section.vector("center", Need::required, sphere.shape.center, coordinate_rules);
  section.number("radius", Need::required, sphere.shape.radius, radius_rules);
  read_surface(section, sphere.material);
  section.flag("transparent", Need::optional, sphere.material.transparent);
  section.number("refractive_index", Need::optional, sphere.material.refractive_index, refractive_index_rules);
  section.finish();
}

void read_point_light(Section& section, PointLight& light) {
  section.vector("position", Need::required, light.position, coordinate_rules);
  section.number("intensity", Need::required, light.intensity, intensity_rules);
  section.finish();
}

void read_directional_light(Section& section, DirectionalLight& light) {
  section.direction("direction", Need::required, light.direction);
  section.number("intensity", Need::required, light.intensity, intensity_rules);
  section.finish();
}

void read_ambient_light(Section& section, AmbientLight& light) {
  section.number("intensity", Need::required, light.intensity, intensity_rules);
  section.finish();
}

class SceneReader {
 public:
  explicit SceneReader(const fs::path& name) : folder_(name.parent_path()), report_(name.string()) {}

  SceneFile read(std::string_view toml) {
    if (const std::optional<TomlTable> root = parse_toml(toml, report_)) read_root(Section(*root, "", {1, 1}, report_));
    const bool good = !report_.has_error() && clouds_are_good_;
    if (good) warn_of_surprises(scene_, places_, report_);
    SceneFile file{{}, report_.sorted(), std::move(tables_)};
    file.diagnostics.insert(file.diagnostics.end(), in_clouds_.begin(), in_clouds_.end());
    if (good) file.scene = std::move(scene_);
    return file;
  }

 private:
  void read_root(Section root) {
    root.text("title", Need::optional, scene_.title);
    root.whole("max_bounces", Need::optional, scene_.max_bounces, 0, 100);
    root.vector("background", Need::optional, scene_.background, color_rules);
    if (std::optional<Section> camera = root.table("camera")) {
      read_camera(*camera, scene_.camera);
      places_.camera_position = camera->place("position");
    } else if (!root.has("camera")) {
      root.error("camera", "missing, write a table [camera] with position, facing and up");
    }
    if (std::optional<Section> image = root.table("image")) read_image(*image, scene_.image);
    places_.planes = read_all(root.tables("plane"), scene_.planes, read_plane);
    places_.spheres = read_all(root.tables("sphere"), scene_.spheres, read_sphere);
    places_.clouds = read_all(root.tables("sphere_cloud"), scene_.clouds,
                              [this](Section& section, SphereCloud& cloud) { read_cloud(section, cloud); });
    read_all(root.tables("point_light"), scene_.point_lights, read_point_light);
    read_all(root.tables("directional_light"), scene_.directional_lights, read_directional_light);
    read_all(root.tables("ambient_light"), scene_.ambient_lights, read_ambient_light);
    root.finish();
  }

  /// Reads each section into an object of its own; returns where they stand.
  template <class Object, class Read>
  static std::vector<Place> read_all(std::vector<Section> sections, std::vector<Object>& objects, const Read& read) {
    std::vector<Place> places;
    for (Section& section : sections) {
      read(section, objects.emplace_back());
      places.push_back(section.place());
    }
    return places;
  }

  void read_cloud(Section& section, SphereCloud& cloud) {
    std::string file;
    CloudTable table = section.text("file", Need::required, file) ? read_table(section, file) : CloudTable{};
    const Need need = table.has_colors == false ? Need::required : Need::optional;
    const bool color = section.vector("color", need, cloud.material.color, color_rules);
    section.number("shininess", Need::optional, cloud.material.shininess, shininess_rules);
    section.finish();
    if (color && table.has_colors == true) section.warning("color", "not used: " + file + " has a color for each sphere");
    cloud.spheres = std::move(table.spheres);
    cloud.colors = std::move(table.colors);
  }

  CloudTable read_table(const Section& section, const std::string& file) {
    const fs::path path = folder_ / file;
    const FileText text = read_file(path, most_cloud_bytes);
    if (!text.text) {
      section.error("file", "cannot read " + path.string() + ": " + text.error);
      return {};
    }
    tables_.push_back(path);
    Report report(path.string());
    CloudTable table = parse_cloud(*text.text, section.name(), report);
    clouds_are_good_ = clouds_are_good_ && !report.has_error();
    const std::vector<Diagnostic> found = report.sorted();
    in_clouds_.insert(in_clouds_.end(), found.begin(), found.end());
    return table;
  }

  fs::path folder_;
  Report report_;
  std::vector<fs::path> tables_;
  std::vector<Diagnostic> in_clouds_;
  bool clouds_are_good_ = true;
  Scene scene_;
  ScenePlaces places_;
};

}  // namespace

SceneFile read_scene(const fs::path& path) {
  const FileText file = read_file(path, most_scene_bytes);
  if (file.text) return parse_scene(*file.text, path);
  return {{}, {{Diagnostic::Severity::error, path.string(), 0, 0, {}, file.error}}};
}

SceneFile parse_scene(std::string_view toml, const fs::path& name) { return SceneReader(name).read(toml); }

}  // namespace raylab
