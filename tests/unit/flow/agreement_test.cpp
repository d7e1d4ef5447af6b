// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// `typegen --diff` and the ports of plugins judge a change alike, or it is known why not: agreement/changes.txt.
#include <clang/types/type_reader.hpp>
#include <collect/close_model.hpp>
#include <diff/compare_models.hpp>

#include <rtt/types/Schema.hpp>

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace oroforge;

namespace {

struct Case {
    int number;
    std::string name, diff, ports, reason;
};
void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<Case> readTable() {
    std::vector<Case> cases;
    std::ifstream in(AGREEMENT_TABLE);
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> parts;
        std::istringstream columns(line);
        for (std::string part; std::getline(columns, part, '|');) parts.push_back(trimmed(part));
        parts.resize(6);
        cases.push_back({static_cast<int>(cases.size()), parts[0], parts[3], parts[4], parts[5]});
    }
    return cases;
}

model::TypeModel read(const std::string& version) {
    const std::string header = AGREEMENT_DIR "/" + version + "/changes.hpp";
    cxx::ParseRequest request;
    request.headers = {{header, "changes.hpp"}};
    diag::Sink sink;
    auto model = cxx::readTypes(request, sink);
    if (model) typekit::closeModel(*model, sink);
    EXPECT_FALSE(sink.hadErrors()) << sink.all().front().message;
    return model.value();
}

/// The changes of all cases.
const std::vector<typekit::Change>& changes() {
    static const auto all = typekit::compareModels(read("old"), read("new"));
    return all;
}

std::string judgedByDiff(const std::string& name) {
    std::string verdict = "none";
    for (const typekit::Change& change : changes()) {
        if (change.message.find("'" + name + "::") == std::string::npos) continue;
        if (change.breaking) return "breaking";
        verdict = "compatible";
    }
    return verdict;
}

const RTT::types::Schema& schema(const char* library, int number) {
    void* const handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) throw std::runtime_error(dlerror());
    const auto find = reinterpret_cast<const RTT::types::Schema* (*)(int)>(dlsym(handle, "schemaOfChange"));
    return *find(number);
}

class Judges : public testing::TestWithParam<Case> {};

}  // namespace

TEST_P(Judges, SayWhatTheTableSays) {
    const Case& one = GetParam();
    EXPECT_EQ(judgedByDiff(one.name), one.diff);
    const RTT::types::Schema& old = schema(AGREEMENT_OLD, one.number);
    const RTT::types::Schema& now = schema(AGREEMENT_NEW, one.number);
    ASSERT_EQ(old.name, one.name + "::S");
    const std::string difference = RTT::types::schemaDifference(old, now, "before", "now");
    EXPECT_EQ(difference.empty() ? "connected" : "refused", one.ports) << difference;
    EXPECT_EQ(RTT::types::schemaDifference(now, old, "now", "before").empty(), difference.empty());
}

TEST_P(Judges, AgreeOrItIsSaidWhyNot) {
    const Case& one = GetParam();
    const bool agree = (one.diff == "breaking") == (one.ports == "refused");
    EXPECT_EQ(agree, one.reason.empty()) << one.reason;
}

INSTANTIATE_TEST_SUITE_P(Changes, Judges, testing::ValuesIn(readTable()),
                         [](const auto& info) { return info.param.name; });
