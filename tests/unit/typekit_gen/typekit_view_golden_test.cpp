// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What typegen reads from the headers of tests/golden/typekit_view, and what its templates are filled with. The text that
// comes of it is compiled and loaded by golden_typekit_test, and kept for the few cases of tests/golden/typekit.
#include <algorithm>

#include <nlohmann/json.hpp>

#include <support/golden.hpp>
#include <support/run_typegen.hpp>

using namespace oroforge::test;
using Json = nlohmann::ordered_json;

namespace {

/// Empty texts are in the view as C++ writes them, too.
bool isEmpty(const Json& value) { return value.empty() || value == "" || value == R"("")"; }

/// What is left when all that is empty has gone.
Json pruned(const Json& value) {
    if (!value.is_structured()) return value;
    Json left = value.is_array() ? Json::array() : Json::object();
    for (const auto& [key, element] : value.items()) {
        Json kept = pruned(element);
        if (value.is_array())
            left.push_back(std::move(kept));
        else if (!isEmpty(kept))
            left[key] = std::move(kept);
    }
    return left;
}

constexpr std::size_t kWidth = 140;

/// As many values on a line as it has place for; an array or object that does not fit is broken.
std::string lines(const Json& value, const std::string& indent = "") {
    const std::string whole = value.dump();
    if (!value.is_structured() || indent.size() + whole.size() < kWidth) return whole;
    std::string text(1, whole.front());
    std::size_t place = 0;
    for (const auto& [key, element] : value.items()) {
        const std::string part = (value.is_array() ? "" : Json(key).dump() + ":") + lines(element, indent + " ");
        if (place < part.size() || element.is_structured()) {
            text += "\n" + indent + " ";
            place = element.is_structured() ? part.size() : kWidth;
        }
        text += part + ",";
        place -= std::min(place, part.size() + 1);
    }
    text.back() = '\n';
    return text + indent + whole.back();
}

class TypekitView : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(TypekitView, IsMadeOfWhatHeadersDefine) {
    const auto dir = goldenDir("typekit_view", GetParam());
    const Ran model = runTypegenIn(dir, {"--dump=model"});
    EXPECT_EQ(model.status, 0);
    EXPECT_EQ(model.err, "");
    expectGolden(dir / "expected/model.json", lines(pruned(Json::parse(model.out))) + "\n");
    const Json view = pruned(Json::parse(runTypegenIn(dir, {"--dump=view"}).out));
    expectGolden(dir / "expected/view.json", lines(view) + "\n");
}

INSTANTIATE_TEST_SUITE_P(Golden, TypekitView, testing::ValuesIn(goldenCases("typekit_view")), caseName);
