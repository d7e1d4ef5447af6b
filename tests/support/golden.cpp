// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "golden.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>

#include "temp_dir.hpp"
#include "text_diff.hpp"

namespace fs = std::filesystem;

namespace oroforge::test {

namespace {

bool isSet(const char* name, const std::string& value) {
    const char* found = std::getenv(name);
    return found != nullptr && value == found;
}

bool updating() {
    if (!isSet("UPDATE_GOLDENS", "1")) return false;
    if (isSet("CI", "true")) {
        ADD_FAILURE() << "UPDATE_GOLDENS=1 is refused when CI=true: goldens are rewritten by people, not by CI";
        return false;
    }
    return true;
}

std::string acceptCommand() {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string filter = "*";
    if (test != nullptr) filter = std::string(test->test_suite_name()) + "." + test->name();
    std::error_code ignored;
    return "UPDATE_GOLDENS=1 " + fs::read_symlink("/proc/self/exe", ignored).string() + " --gtest_filter=" + filter;
}

bool hasWhatItNeeds(const fs::path& dir) {
    std::ifstream file(dir / "needs");
    for (std::string path; std::getline(file, path);)
        if (!fs::exists(path)) return false;
    return true;
}

std::string relativeName(const fs::path& file) { return file.lexically_relative(sourceRoot()).generic_string(); }

}  // namespace

fs::path sourceRoot() { return OROFORGE_SOURCE_DIR; }

std::vector<std::string> goldenCases(const std::string& kind) {
    std::vector<std::string> names;
    const fs::path root = sourceRoot() / "tests/golden" / kind;
    if (!fs::is_directory(root)) return names;
    for (const auto& entry : fs::directory_iterator(root)) {
        if (entry.is_directory() && hasWhatItNeeds(entry.path())) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

fs::path goldenDir(const std::string& kind, const std::string& name) {
    return sourceRoot() / "tests/golden" / kind / name;
}

void expectGolden(const fs::path& expected, const std::string& actual) {
    const bool update = updating();
    const std::string before = fs::exists(expected) ? readFile(expected) : std::string();
    if (before == actual) return;
    if (update) return writeFile(expected, actual);
    ADD_FAILURE() << unifiedDiff(before, actual, relativeName(expected)) << "\nto accept: " << acceptCommand();
}

void expectGoldenTree(const fs::path& expected, const std::map<std::string, std::string>& actual) {
    const auto before = readTree(expected);
    for (const auto& [name, text] : actual) expectGolden(expected / name, text);
    for (const auto& [name, text] : before) {
        if (actual.count(name) != 0) continue;
        if (updating()) {
            fs::remove(expected / name);
        } else {
            ADD_FAILURE() << relativeName(expected / name) << " is no longer made\nto accept: " << acceptCommand();
        }
    }
}

std::map<std::string, std::string> readTree(const fs::path& dir) {
    std::map<std::string, std::string> files;
    if (!fs::is_directory(dir)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(dir)) {
        if (entry.is_regular_file()) {
            files[entry.path().lexically_relative(dir).generic_string()] = readFile(entry.path());
        }
    }
    return files;
}

std::string replaceAll(std::string text, const std::string& what, const std::string& with) {
    if (what.empty()) return text;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
        text.replace(at, what.size(), with);
    }
    return text;
}

std::string caseName(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return name;
}

}  // namespace oroforge::test
