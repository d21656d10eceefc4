// docs/results.schema.json: has it the fields that results.json has, and no others?

#include "core/results/results.hpp"

#include "core/calls/plain_json.hpp"
#include "core/image/data_folder.hpp"
#include "tests/catch.hpp"
#include "tests/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <type_traits>
#include <vector>

using namespace raylab;
using namespace raylab::test;

using Json = nlohmann::ordered_json;

namespace {

/// Says where a JSON schema is not what PlainJson writes of a type.
struct SchemaCheck {
  const Json& root;

  Json resolved(const Json& schema) const {
    return schema.contains("$ref") ? root.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))) : schema;
  }

  template <class T>
  void check(const Json& given) const {
    const Json schema = resolved(given);
    if constexpr (HasFields<T>)
      check_struct<T>(schema);
    else if constexpr (std::is_enum_v<T>)
      check_enum<T>(schema);
    else if constexpr (std::is_same_v<T, bool>)
      CHECK(schema["type"] == "boolean");
    else if constexpr (std::is_integral_v<T>)
      CHECK(schema["type"] == "integer");
    else if constexpr (std::is_same_v<T, double>)
      CHECK(schema["type"] == "number");
    else if constexpr (std::is_same_v<T, std::string>)
      CHECK(schema["type"] == "string");
    else
      check_list<typename T::value_type>(schema);
  }

  template <class T>
  void check_enum(const Json& schema) const {
    std::vector<std::string> names;
    for_each_name(T{}, [&](const char* name, T) { names.emplace_back(name); });
    CHECK(schema["enum"].get<std::vector<std::string>>() == names);
  }

  template <class T>
  void check_list(const Json& schema) const {
    CHECK(schema["type"] == "array");
    check<T>(schema["items"]);
  }

  template <class T>
  void check_struct(const Json& schema) const {
    CHECK(schema["additionalProperties"] == false);
    std::vector<std::string> names, properties;
    for (const auto& [name, property] : schema["properties"].items()) properties.push_back(name);
    for_each_field(T{}, [&]<class Part>(const Field& field, const Part&) {
      names.emplace_back(field.name);
      INFO(field.name);
      REQUIRE(schema["properties"].contains(field.name));
      check<Part>(schema["properties"][field.name]);
    });
    CHECK(properties == names);
    CHECK(schema["required"].get<std::vector<std::string>>() == names);
  }
};

}  // namespace

TEST_CASE("results: the schema has the fields that results.json has, and no others", "[results]") {
  const Json schema = Json::parse(bytes_of(data_folder("docs/results.schema.json")));
  SchemaCheck{schema}.check<ClassResults>(schema);
  CHECK(schema["properties"]["format"]["const"] == ClassResults{}.format);
}
