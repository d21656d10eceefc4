// What the reader says of keys that it does not know, and of texts that are no TOML or no UTF-8.
#include "tests/scene_text.hpp"

using namespace raylab;
using namespace raylab::test;

namespace {

const std::vector<BadScene> bad_texts{
    {"an unknown key names the nearest",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "  colour = [1, 1, 1]\n",
     {"scene.toml:6:3: sphere[0].colour: unknown key, did you mean 'color'?"}},
    {"swapped letters are near",
     camera + "[[sphere]]\n"
              "centre = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:2:1: sphere[0].center: missing, must be a list of 3 numbers",
      "scene.toml:3:1: sphere[0].centre: unknown key, did you mean 'center'?"}},
    {"capitals are near",
     camera + "[[ambient_light]]\n"
              "Intensity = 1\n",
     {"scene.toml:2:1: ambient_light[0].intensity: missing, must be a number",
      "scene.toml:3:1: ambient_light[0].Intensity: unknown key, did you mean 'intensity'?"}},
    {"a key far from all gets the list",
     camera + "[[ambient_light]]\n"
              "intensity = 1\n"
              "brightness_of_it = 2\n",
     {"scene.toml:4:1: ambient_light[0].brightness_of_it: unknown key; known keys: intensity"}},
    {"swapped letters of a short key",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0, -1]\n"
     "pu = [0, 1, 0]\n",
     {"scene.toml:1:1: camera.up: missing, must be a list of 3 numbers",
      "scene.toml:4:1: camera.pu: unknown key, did you mean 'up'?"}},
    {"capitals of a short key",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0, -1]\n"
     "UP = [0, 1, 0]\n",
     {"scene.toml:1:1: camera.up: missing, must be a list of 3 numbers",
      "scene.toml:4:1: camera.UP: unknown key, did you mean 'up'?"}},
    {"an unknown key at the top",
     camera + "widht = 3\n",
     {"scene.toml:2:1: widht: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, "
      "sphere_cloud, point_light, directional_light, ambient_light"}},
    {"an unknown table",
     camera + "[[spheres]]\n"
              "radius = 1\n",
     {"scene.toml:2:3: spheres: unknown key, did you mean 'sphere'?"}},
    {"an unknown table below a known one",
     camera + "[image]\n"
              "[image.sizes]\n",
     {"scene.toml:3:8: image.sizes: unknown key; known keys: width, height"}},
    {"an unknown quoted key is shown in one line",
     camera + "\"a\\n"
              "\\u001b\" = 1\n",
     {"scene.toml:2:1: a\\x0a\\x1b: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, "
      "sphere_cloud, point_light, directional_light, ambient_light"}},
    {"a long unknown key is cut",
     camera + std::string(100, 'x') + " = 1\n",
     {"scene.toml:2:1: xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...: unknown key; known keys: title, "
      "max_bounces, background, camera, image, plane, sphere, sphere_cloud, point_light, directional_light, ambient_light"}},
    {"every mistake is reported in one run",
     "max_bounces = 999\n"
     "titel = \"x\"\n"
     "[camera]\n"
     "facing = [0, 0, nan]\n"
     "up = 3\n"
     "[image]\n"
     "width = 1.5\n"
     "height = 0\n"
     "[[plane]]\n"
     "normal = [0, 0, 0]\n"
     "color = [-1, 2, -3]\n"
     "[[sphere]]\n"
     "center = [1, 2]\n"
     "radius = -1\n"
     "color = [1, 1, 1]\n"
     "shine = 3\n"
     "[[point_light]]\n"
     "position = [0, 0, 0]\n"
     "[lights]\n"
     "x = 1\n",
     {"scene.toml:1:15: max_bounces: must be between 0 and 100, got 999",
      "scene.toml:2:1: titel: unknown key, did you mean 'title'?",
      "scene.toml:3:1: camera.position: missing, must be a list of 3 numbers",
      "scene.toml:4:17: camera.facing[2]: must be a finite number, got nan",
      "scene.toml:5:6: camera.up: must be a list of 3 numbers, got 3",
      "scene.toml:7:9: image.width: must be a whole number, got 1.5",
      "scene.toml:8:10: image.height: must be between 1 and 65536, got 0",
      "scene.toml:9:1: plane[0].point: missing, must be a list of 3 numbers",
      "scene.toml:10:10: plane[0].normal: must not be [0, 0, 0]: a direction has a length",
      "scene.toml:11:10: plane[0].color[0]: must be at least 0, got -1",
      "scene.toml:11:17: plane[0].color[2]: must be at least 0, got -3",
      "scene.toml:13:10: sphere[0].center: must be a list of 3 numbers, got a list of 2",
      "scene.toml:14:10: sphere[0].radius: must be greater than 0, got -1",
      "scene.toml:16:1: sphere[0].shine: unknown key; known keys: center, radius, color, shininess, transparent, "
      "refractive_index",
      "scene.toml:17:1: point_light[0].intensity: missing, must be a number",
      "scene.toml:19:2: lights: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, "
      "sphere_cloud, point_light, directional_light, ambient_light"}},
    {"columns count characters",
     camera + "title = 3\n"
              "sphere = [{radius = \"\xc3\xa4\", center = nan, color = [1,1,1]}]\n",
     {"scene.toml:2:9: title: must be a string, got 3", "scene.toml:3:21: sphere[0].radius: must be a number, got a string",
      "scene.toml:3:35: sphere[0].center: must be a list of 3 numbers, got nan"}},
    {"CRLF",
     camera + "max_bounces = -1\r\n"
              "[image]\r\n"
              "width = 0\r\n",
     {"scene.toml:2:15: max_bounces: must be between 0 and 100, got -1",
      "scene.toml:4:9: image.width: must be between 1 and 65536, got 0"}},
    {"a byte order mark",
     "\xef\xbb\xbf"
     "camera = {position = [0, 0, 0], facing = [0, 0, -1], up = [0, 1, 0]}\n"
     "max_bounces = -1\n",
     {"scene.toml:2:15: max_bounces: must be between 0 and 100, got -1"}},
    {"a syntax error ends the list",
     camera + "max_bounces = -1\n"
              "[image\n"
              "width = 0\n",
     {"scene.toml:3:7: not valid TOML (table header): expected ']', saw '\\n'"}},
    {"a text needs quotes",
     camera + "title = hello\n",
     {"scene.toml:2:9: not valid TOML (value): could not determine value type; a text needs quotes"}},
    {"a key stands once",
     camera + "max_bounces = 1\n"
              "max_bounces = 2\n",
     {"scene.toml:3:15: not valid TOML (key-value pair): cannot redefine existing integer 'max_bounces'; write it once"}},
    {"a table stands once",
     camera + "[image]\n"
              "[image]\n",
     {"scene.toml:3:1: not valid TOML (table header): cannot redefine existing table 'image'; write it once"}},
    {"single after double brackets",
     camera + "[[sphere]]\n"
              "[sphere]\n",
     {"scene.toml:3:1: not valid TOML (table header): cannot redefine existing array 'sphere' as table; write [[double "
      "brackets]] each time"}},
    {"a number beyond doubles",
     camera + "[[ambient_light]]\n"
              "intensity = 1e400\n",
     {"scene.toml:3:13: not valid TOML (floating-point): '1e400' could not be interpreted as a value; the largest number is "
      "1.797e308"}},
    {"a whole number beyond 64 bits",
     camera + "[[ambient_light]]\n"
              "intensity = 9223372036854775808\n",
     {"scene.toml:3:13: not valid TOML (decimal integer): '9223372036854775808' is not representable in 64 bits; write so "
      "large a number with an exponent, as in 1e20, up to 1.797e308"}},
    {"a number of 200 digits",
     camera + "[[ambient_light]]\nintensity = 0." + std::string(200, '1') + "\n",
     {"scene.toml:3:13: not valid TOML (floating-point): exceeds length limit of 128 digits (consider using exponent "
      "notation); 17 digits are enough for any number"}},
    {"a decimal comma",
     camera + "[[ambient_light]]\n"
              "intensity = 1,5\n",
     {"scene.toml:3:14: not valid TOML (key-value pair): expected a comment or whitespace, saw ','"}},
    {"an open string",
     camera + "title = \"x\n",
     {"scene.toml:2:11: not valid TOML (string): unescaped control characters other than TAB (U+0009) are explicitly "
      "prohibited"}},
    {"a list without commas",
     camera + "background = [0 0 0]\n",
     {"scene.toml:2:17: not valid TOML (array): expected comma or closing ']', saw '0'"}},
    {"true is small",
     camera + "[[sphere]]\n"
              "transparent = True\n",
     {"scene.toml:3:15: not valid TOML (boolean): expected 'true', saw 'T'; write true; a text needs quotes"}},
    {"a NUL",
     camera + std::string("max_bounces = 1\x00\n", 17),
     {"scene.toml:2:16: a space or a comma is missing before this text"}},
    {"letters beyond ASCII need quotes",
     camera + "gr\xc3\xb6\xc3\x9f"
              "e = 1\n",
     {"scene.toml:2:3: a character that may stand in quotes or behind a # only"}},
    {"a key in quotes next to a letter beyond ASCII",
     camera + "\"a\" = 1\n"
              "\"b\"\xc3\xa4 = 1\n",
     {"scene.toml:3:4: a character that may stand in quotes or behind a # only"}},
    {"control characters stand nowhere",
     camera + "[\x01image]\n",
     {"scene.toml:2:2: a character that may stand in quotes or behind a # only"}},
    {"a text touches a number before it",
     camera + "background = [0\"\xc3\xa4\", 0, 0]\n",
     {"scene.toml:2:17: a space or a comma is missing before this text"}},
    {"a line end is shown in one line",
     camera + "max_bounces = i\n"
              "\n",
     {"scene.toml:2:16: not valid TOML (floating-point): expected 'inf', saw 'i\\x0a'; write inf; a text needs quotes"}},
    {"a long key is cut between characters",
     camera +
         "\"a\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3"
         "\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3"
         "\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\" = 1\n",
     {"scene.toml:2:1: "
      "a\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4"
      "\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3"
      "\xa4...: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, sphere_cloud, "
      "point_light, "
      "directional_light, ambient_light"}},
    {"a text touches a number and a sign before it",
     camera + "background = 6==\"\xc3\xa4\"\n",
     {"scene.toml:2:18: a space or a comma is missing before this text"}},
    {"a text touches a number behind its key",
     camera + "max_bounces=6=\"\xc3\xa4\"\n",
     {"scene.toml:2:16: a space or a comma is missing before this text"}},
    {"a text touches a number and one sign",
     camera + "max_bounces = 6=\"\xc3\xa4\"\n",
     {"scene.toml:2:18: a space or a comma is missing before this text"}},
    {"a backslash before a letter beyond ASCII",
     camera + "title = \"\\\xc3\xa4\"\n",
     {"scene.toml:2:11: a backslash may not stand before this character"}},
    {"a backslash at a line end before a letter beyond ASCII",
     camera + "title = \"\"\"a \\\n"
              "  \xc3\xa4\"\"\"\n",
     {"scene.toml:3:3: a backslash may not stand before this character"}},
    {"a text touches a number that touches its key",
     camera + "max_bounces=6\"\xc3\xa4\"\n",
     {"scene.toml:2:15: a space or a comma is missing before this text"}},
    {"a text touches a number with a bracket",
     camera + "background=[6[=\"\xc3\xa4\"]]\n",
     {"scene.toml:2:17: a space or a comma is missing before this text"}},
    {"a letter beyond ASCII touches a number",
     camera + "max_bounces = 6\xc3\xa4\n",
     {"scene.toml:2:16: a space or a comma is missing before this text"}},
    {"a text touches a sign",
     camera + "background = [-\"\xc3\xa4\", 0, 0]\n",
     {"scene.toml:2:17: a space or a comma is missing before this text"}},
    {"a text may touch a comma behind a number",
     camera + "background=[1,\"\xc3\xa4\",2]\n",
     {"scene.toml:2:15: background[1]: must be a number, got a string"}},
    {"a text may follow a bracket behind a number",
     camera + "background=[[1],\"\xc3\xa4\",2]\n",
     {"scene.toml:2:13: background[0]: must be a number, got a list of 1",
      "scene.toml:2:17: background[1]: must be a number, got a string"}},
    {"a text may follow a space behind a number",
     camera + "image={width = 1 ,height=\"\xc3\xa4\"}\n",
     {"scene.toml:2:26: image.height: must be a whole number, got a string"}},
    {"a text may follow a name that ends in a digit",
     camera + "title1=\"\xc3\xa4\"\n",
     {"scene.toml:2:1: title1: unknown key, did you mean 'title'?"}},
    {"a text of three quotes ends in up to five",
     camera + "image = {a = '''b'''', \xc3\xa4 = 1}\n",
     {"scene.toml:2:24: a character that may stand in quotes or behind a # only"}},
    {"columns count characters in what TOML does not read too",
     camera + "title = \"\xc3\xa4\" \xc3\xb6\n",
     {"scene.toml:2:13: a character that may stand in quotes or behind a # only"}},
    {"keys of many parts",
     camera + "a.a.a.a.a.a.a.a.a.a = 1\n",
     {"scene.toml:2:18: more dots than any key of a scene has; a text needs quotes"}},
    {"lists too deep",
     camera + "background = " + std::string(300, '[') + "\n",
     {"scene.toml:2:270: not valid TOML (value): exceeded maximum nested value depth of 256 (TOML_MAX_NESTED_VALUES)"}},
    {"not UTF-8", camera + "title = \"\xe4\"\n", {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"half a UTF-8 character",
     camera + "title = \"\xc3",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"UTF-16",
     std::string("\xff\xfem\x00"
                 "a\x00x\x00_\x00"
                 "b\x00o\x00u\x00n\x00"
                 "c\x00"
                 "e\x00s\x00 \x00=\x00 \x00"
                 "1\x00",
                 32),
     {"scene.toml:1:1: UTF-16 text; save the file as UTF-8"}},
    {"half of a UTF-16 pair",
     camera + "title = \"\xed\xa0\x80\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"a character beyond Unicode",
     camera + "title = \"\xf4\x90\x80\x80\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"an overlong character",
     camera + "title = \"\xe0\x9f\xbf\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"an overlong slash",
     camera + "title = \"\xc0\xaf\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"a wrong escape",
     camera + "title = \"\\q\"\n",
     {"scene.toml:2:11: not valid TOML (string): unknown escape sequence '\\q'"}},
    {"an overlong character of four",
     camera + "title = \"\xf0\x8f\xbf\xbf\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
};

}  // namespace

TEST_CASE("scene: unknown keys and what is no TOML are reported with their place and what is likely meant", "[scene]") {
  check_bad(bad_texts);
}
