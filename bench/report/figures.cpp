#include "bench/report/figures.hpp"

#include <ostream>
#include <utility>

namespace raylab::bench {
namespace {

/// Figures of one thing that was measured.
class Sheet {
 public:
  Sheet(std::vector<Figure>& all, std::string section) : all_(all) { about_.section = std::move(section); }

  Sheet& on(std::string subject) {
    about_.subject = std::move(subject);
    return *this;
  }
  Sheet& of(std::string variant) {
    about_.variant = std::move(variant);
    return *this;
  }

  /// A figure that each run gives anew; none where it is null.
  void exact(const char* what, const char* unit, const Json& value, bool more_is_better = false) {
    if (value.is_null()) return;
    Figure figure = about_;
    figure.what = what;
    figure.unit = unit;
    figure.value = value;
    figure.more_is_better = more_is_better;
    all_.push_back(std::move(figure));
  }

  /// What spread() gives.
  void timed(const char* what, const char* unit, const Json& value, bool more_is_better = false) {
    exact(what, unit, value["median"], more_is_better);
    all_.back().low = value["low"];
    all_.back().high = value["high"];
    all_.back().noisy = value["noisy"];
  }

  /// What image_error() gives.
  void error(const std::string& kind, const Json& error) {
    for (const char* const name : {"rmse", "max", "rmse_rest", "max_rest", "rmse_judged"})
      exact((kind + " " + name).c_str(), "", error[name]);
    exact((kind + " psnr").c_str(), "dB", error["psnr"], true);
    for (const char* const name : {"flipped", "non_finite"}) exact((kind + " " + name).c_str(), "pixels", error[name]);
  }

 private:
  std::vector<Figure>& all_;
  Figure about_;
};

void add_images(std::vector<Figure>& all, const Json& images) {
  for (const Json& scene : images["scenes"]) {
    Sheet sheet(all, "images");
    sheet.on(scene["scene"]);
    sheet.of("oracle").exact("speed", "Mpixel/s", scene["oracle_mpixels_per_second"], true);
    for (const Json& variant : scene["variants"]) {
      sheet.of(variant["id"]).timed("speed", "Mpixel/s", variant["mpixels_per_second"], true);
      sheet.error("arithmetic", variant["arithmetic"]);
    }
    for (const Json& pattern : scene["sampling"]) {
      sheet.of(pattern["aa"]).timed("sampling speed", "Mpixel/s", pattern["mpixels_per_second"], true);
      sheet.error("sampling", pattern["error"]);
    }
    for (const Json& model : scene["model"]) sheet.of(model["variant"]).error("model", model["error"]);
  }
}

void add_kernels(std::vector<Figure>& all, const Json& kernels) {
  for (const Json& task : kernels)
    for (const Json& family : task["families"]) {
      Sheet sheet(all, "kernels");
      sheet.on(task["task"].get<std::string>() + " " + task["name"].get<std::string>() + ", " +
               family["family"].get<std::string>());
      for (const Json& result : family["results"]) {
        sheet.of(result["by"].get<std::string>() + " " + result["precision"].get<std::string>());
        sheet.timed("time", "ns", result["ns"]);
        if (!result["ulps"].is_null()) {
          sheet.exact("median error", "ulp", result["ulps"]["median"]);
          sheet.exact("greatest error", "ulp", result["ulps"]["max"]);
        }
        sheet.exact("greatest error beyond condition", "", result["unexplained"]);
        sheet.exact("wrong decisions", "answers", result["wrong_decisions"]);
        sheet.exact("not finite", "answers", result["non_finite"]);
      }
    }
}

void add_growth(std::vector<Figure>& all, const Json& growth) {
  Sheet sheet(all, "growth");
  for (const Json& series : growth["series"])
    for (const Json& curve : series["curves"])
      for (const Json& point : curve["points"]) {
        sheet.on(series["x"].get<std::string>() + " = " + point["x"].dump()).of(curve["name"]);
        sheet.timed("time", "s", point["seconds"]);
        if (point["prepare_seconds"].is_null()) continue;
        sheet.timed("time to prepare", "s", point["prepare_seconds"]);
        sheet.exact("memory to prepare", "bytes", point["bytes"]);
        all.back().low = all.back().high = all.back().value;
      }
  for (const Json& feature : growth["features"]) {
    sheet.on(feature["feature"]).of("without").timed("time", "s", feature["without"]);
    sheet.of("with").timed("time", "s", feature["with"]);
  }
}

void add_edges(std::vector<Figure>& all, const Json& edges) {
  Sheet sheet(all, "edges");
  for (const Json& pattern : edges["patterns"])
    for (const Json& point : pattern["points"])
      sheet.on(point["degrees"].dump() + " degrees").of(pattern["aa"]).exact("rmse", "", point["rmse"]);
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + '"';
}

}  // namespace

std::vector<Figure> figures_of(const Json& report) {
  std::vector<Figure> all;
  if (report.contains("images")) add_images(all, report["images"]);
  if (report.contains("kernels")) add_kernels(all, report["kernels"]);
  if (report.contains("growth")) add_growth(all, report["growth"]);
  if (report.contains("edges") && !report["edges"].is_null()) add_edges(all, report["edges"]);
  return all;
}

void write_csv(std::ostream& out, const std::vector<Figure>& figures) {
  out << "section,subject,variant,what,unit,value,low,high,noisy\r\n";
  for (const Figure& figure : figures) {
    for (const std::string* text : {&figure.section, &figure.subject, &figure.variant, &figure.what, &figure.unit})
      out << quoted(*text) << ',';
    out << Json(figure.value).dump() << ',';
    for (const std::optional<double>& quartile : {figure.low, figure.high})
      out << (quartile ? Json(*quartile).dump() : "") << ',';
    out << (figure.noisy ? "noisy" : "") << "\r\n";
  }
}

}  // namespace raylab::bench
