#include "core/cli/command.hpp"
#include "core/render/engine.hpp"

#include <exception>
#include <iostream>

int main(int argc, char** argv) {
  using namespace raylab::cli;
  CLI::App app(
      "A staged ray tracing lab: write a renderer in seven stages, and see what each of them makes of a scene.\n\n"
      "Examples:\n"
      "  raylab new my-lab                                    a folder to work in\n"
      "  raylab render scenes/scene5.toml                     the finished picture, out/scene5-ssaa.png\n"
      "  raylab render scenes/scene5.toml --stage shadows     what stage 4 makes of it\n"
      "  raylab sheet scenes/scene5.toml                      all stages side by side\n"
      "  raylab test 5                                        the tests of stage 5\n"
      "  raylab diff mine.exr --scene scene3 --stage 5        what is wrong with a picture\n"
      "  raylab explain scenes/scene3.toml --pixel 320,240    how a pixel gets its color, and what is wrong in yours\n"
      "  raylab call schlick '{\"cos_theta\": 0.5, \"refractive_index\": 1.5}'   one function of a stage\n"
      "  raylab grade submissions --out graded                a class, in a sandbox\n"
      "  raylab bench --quick                                 speed against error on this machine, as a page\n"
      "  raylab COMMAND --help                                more about a command",
      "raylab");
  app.set_version_flag("--version", RAYLAB_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  add_new(app);
  add_render(app);
  add_sheet(app);
  add_check_scene(app);
  add_stages(app);
  add_call(app);
  add_diff(app);
  add_test(app);
  add_explain(app);
#ifdef RAYLAB_WITH_BENCH
  add_bench(app);
#endif
  add_handout(app);
#ifdef RAYLAB_WITH_GRADE
  add_grade(app);
  add_grade_one(app);
  add_merge(app);
#endif
  add_reference(app);
  add_doctor(app);

  try {
    app.parse(argc, argv);
    return success;
  } catch (const CLI::RuntimeError& verdict) {
    return verdict.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? success : wrong_usage;
  } catch (const raylab::Cancelled&) {
    std::cerr << "raylab: interrupted, nothing was written\n";
    return interrupted;
  } catch (const Failure& error) {
    std::cerr << "raylab: " << error.what() << '\n';
    return error.code;
  } catch (const std::exception& error) {
    std::cerr << "raylab: " << error.what() << '\n';
    return failure;
  }
}
