// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Files as projects have written them, in strangers/: each says in comments what must become of it.
//
//     fails                          it is refused; nothing that it created is left
//     here: KIND CODE                a message for this line; there may be no others
//     says: [FILE:]LINE KIND CODE    a message for another file, or for none of its lines (0)
//     holds: EXPRESSION              is true in the deployer's scripts afterwards; scripts call check(EXPRESSION, "words")
#include <ocl/DeploymentComponent.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/startstop.h>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using namespace oroforge::test;
using testing::IsEmpty;
using testing::UnorderedElementsAreArray;

/** The words behind `key` in the comments of a file: "<!-- key: words -->" or "# key: words". */
std::vector<std::string> comments(const std::string& text, const std::string& key) {
    const std::regex form("(?:<!--|#) " + key + "(?:: (.*?))?(?: -->|\r?\n|$)");
    std::vector<std::string> result;
    for (std::sregex_iterator found(text.begin(), text.end(), form), end; found != end; ++found)
        result.push_back((*found)[1]);
    return result;
}

/** The messages that a file announces, in the form of those below. */
std::vector<std::string> announced(const std::string& text) {
    std::vector<std::string> result = comments(text, "says");
    std::istringstream lines(text);
    int number = 1;
    for (std::string line; std::getline(lines, line); ++number)
        for (const std::string& what : comments(line, "here")) result.push_back(std::to_string(number) + " " + what);
    return result;
}

/** The messages in a text, as "FILE:LINE KIND CODE"; without the file if that is `file`. */
std::vector<std::string> messages(const std::string& text, const std::string& file) {
    static const std::regex form("(?:^|\n|\\] ?)([^\n:\\]]+)(?::(\\d+))?(?::\\d+)?: (error|warning): \\[(\\w+)\\]");
    std::vector<std::string> result;
    for (std::sregex_iterator found(text.begin(), text.end(), form), end; found != end; ++found) {
        const std::string where = (*found)[1].str() == file ? "" : (*found)[1].str() + ":";
        const std::string line = (*found)[2].matched ? (*found)[2].str() : "0";
        result.push_back(where + line + " " + (*found)[3].str() + " " + (*found)[4].str());
    }
    return result;
}

class Strangers : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static char name[] = "strangers_test";
        static char* words[] = {name, nullptr};
        __os_init(1, words);
        RTT::ComponentLoader::Instance()->setComponentPath(DEPLOYER_TEST_PATH);
    }
    static void TearDownTestSuite() { __os_exit(); }

    Strangers() : old_(fs::current_path()) {
        fs::copy(sourceRoot() / "tests/unit/deployer/strangers", directory_.path(), fs::copy_options::recursive);
        fs::current_path(directory_.path());
    }
    ~Strangers() override { fs::current_path(old_); }

    std::vector<std::string> files(const std::string& extension) const {
        std::vector<std::string> result;
        for (const auto& entry : fs::directory_iterator(directory_.path()))
            if (entry.path().extension() == extension) result.push_back(entry.path().filename().string());
        std::sort(result.begin(), result.end());
        return result;
    }

    /** Deploys a file and holds what it says against what became of it. */
    void deploy(const std::string& file, bool (OCL::DeploymentComponent::*how)(const std::string&)) {
        SCOPED_TRACE(file);
        const std::string text = readFile(directory_ / file);
        OCL::DeploymentComponent deployer("Deployer");
        std::vector<std::string> wrong;
        deployer.addOperation("check", [&wrong](bool good, const std::string& what) {
            if (!good) wrong.push_back(what);
        });
        testing::internal::CaptureStderr();
        const bool done = (deployer.*how)(file);
        const std::string said = testing::internal::GetCapturedStderr();
        const bool fails = !comments(text, "fails").empty();
        EXPECT_EQ(!fails, done) << said;
        EXPECT_THAT(messages(said, file), UnorderedElementsAreArray(announced(text))) << said;
        if (fails && file.find(".xml") != std::string::npos) {
            EXPECT_THAT(deployer.getPeerList(), IsEmpty());
        }
        for (const std::string& expression : comments(text, "holds")) {
            testing::internal::CaptureStderr();
            const bool executed = holds(deployer, expression);
            const std::string why = testing::internal::GetCapturedStderr();
            EXPECT_TRUE(executed) << why;
        }
        EXPECT_THAT(wrong, IsEmpty());
        RTT::ConnPolicy::Default() = policy_;
    }

    static bool holds(OCL::DeploymentComponent& deployer, const std::string& expression) {
        EXPECT_TRUE(deployer.loadService("this", "scripting"));
        RTT::OperationCaller<bool(const std::string&)> eval(deployer.provides("scripting")->getOperation("eval"));
        const std::string quoted = replaceAll(replaceAll(expression, "\\", "\\\\"), "\"", "\\\"");
        return eval("check(" + expression + ", \"" + quoted + "\")");
    }

    TempDir directory_;
    fs::path old_;
    const RTT::ConnPolicy policy_ = RTT::ConnPolicy::Default();
};

TEST_F(Strangers, DeploymentFilesDoWhatTheirAuthorsMeant) {
    for (const std::string& file : files(".xml")) deploy(file, &OCL::DeploymentComponent::kickStart);
}

TEST_F(Strangers, EditorsOfOtherSystemsChangeNothing) {
    for (const char* file : {"c01_inline_properties.xml", "e01_blanks.xml"})
        directory_.write(std::string("dos_") + file,
                         "\xEF\xBB\xBF" + replaceAll(readFile(directory_ / file), "\n", "\r\n"));
    directory_.write("params/all.cpf", "\xEF\xBB\xBF" + replaceAll(readFile("params/all.cpf"), "\n", "\r\n"));
    directory_.write("params/some.cpf", replaceAll(readFile("params/some.cpf"), "\n", "\r"));
    for (const char* file : {"dos_c01_inline_properties.xml", "dos_e01_blanks.xml", "c07_property_files.xml"})
        deploy(file, &OCL::DeploymentComponent::kickStart);
}

TEST_F(Strangers, ScriptsDoWhatTheirAuthorsMeant) {
    for (const std::string& file : files(".ops")) deploy(file, &OCL::DeploymentComponent::runScript);
}

}  // namespace
