// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts that deploy an application, among them those of the manuals, run by a deployer.
#include "corpus_file.hpp"

#include <ocl/DeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>
#include <unit/flow/log_capture.hpp>

#include <gmock/gmock.h>

#include <iostream>

namespace {

using namespace scripting_corpus;
using namespace oroforge::test;

class WithDeployer : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static char name[] = "deployment_corpus_test";
        static char* words[] = {name, nullptr};
        __os_init(1, words);
        for (const char* plugin : {RTT_TYPEKIT_FILE, RTT_SCRIPTING_FILE, RTT_MARSHALLING_FILE})
            EXPECT_TRUE(RTT::plugin::PluginLoader::Instance()->loadLibrary(plugin));
    }
    static void TearDownTestSuite() { __os_exit(); }

    WithDeployer() : deployer_(std::make_unique<OCL::DeploymentComponent>("Deployer")) {
        // Scripts name other files relative to themselves.
        std::filesystem::current_path(corpusPath("deployment", "x").parent_path());
        RTT::ComponentLoader::Instance()->setComponentPath(CORPUS_COMPONENT_PATH);
        deployer_->addOperation("note", [this](const std::string& text) { notes_.push_back(text); });
    }

    flow_test::LogCapture log_;
    std::vector<std::string> notes_;
    std::unique_ptr<OCL::DeploymentComponent> deployer_;
};

class DeploymentCorpus : public WithDeployer, public testing::WithParamInterface<std::string> {};

TEST_P(DeploymentCorpus, IsDeployedAndRuns) {
    const std::filesystem::path file = corpusPath("deployment", GetParam());
    EXPECT_TRUE(deployer_->runScript(file.filename().string()));
    EXPECT_THAT(notes_, testing::ElementsAreArray(expectedNotes(readFile(file))));
    if (HasFailure()) std::cerr << log_.text();
    EXPECT_TRUE(deployer_->kickOutAll());
}

TEST_F(WithDeployer, SaysThatTheSlidesSwapArgumentsOfSetActivity) {
    EXPECT_TRUE(deployer_->runScript("parts/slides_as_printed.ops"));
    EXPECT_THAT(
        log_.text(),
        testing::HasSubstr(
            R"(parts/slides_as_printed.ops:4:29: warning: [OPS152] argument 3 (Priority) of 'setActivity' is a whole number (int): what is given loses its fraction
setActivity("producer", 98, 0.01, ORO_SCHED_OTHER)
                            ^
note: argument 2 (Period) is of type double: are the two swapped?
)"));
    EXPECT_EQ(98, deployer_->getPeer("producer")->getPeriod());
}

INSTANTIATE_TEST_SUITE_P(Corpus, DeploymentCorpus, testing::ValuesIn(corpusNames("deployment")), caseName);

}  // namespace
