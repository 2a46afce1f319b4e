#include "preset/judge.h"
#include "preset/schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace frond {

struct SchemaJudge::Library {
  valijson::Schema schema;
};

SchemaJudge::SchemaJudge() : library_(std::make_unique<Library>()) {
  nlohmann::json schema =
      nlohmann::json::parse(serialize_pretty(file_schema<reef::Preset>("Reef", "A test")));
  valijson::adapters::NlohmannJsonAdapter adapter(schema);
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(adapter, library_->schema);
}

SchemaJudge::~SchemaJudge() = default;

bool SchemaJudge::accepts(std::string_view json) {
  nlohmann::json value = nlohmann::json::parse(json, nullptr, true, true);
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  valijson::adapters::NlohmannJsonAdapter adapter(value);
  valijson::ValidationResults results;
  bool good = validator.validate(library_->schema, adapter, &results);
  reason_.clear();
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    for (const std::string& step : error.context) reason_ += step;
    reason_ += ": " + error.description + "\n";
  }
  return good;
}

namespace {

TEST(SchemaJudge, KnowsGoodFromBad) {
  SchemaJudge judge;
  EXPECT_TRUE(judge.accepts(R"({"title": "x"})"));
  EXPECT_FALSE(judge.accepts(R"({"title": 1})"));
  EXPECT_FALSE(judge.reason().empty());
}

}  // namespace
}  // namespace frond
