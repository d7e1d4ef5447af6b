// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A deployer that has imported the component library.
#ifndef OROFORGE_TESTS_COMPONENTS_LIBRARY_FIXTURE_HPP
#define OROFORGE_TESTS_COMPONENTS_LIBRARY_FIXTURE_HPP

#include <ocl/DeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>

#include <gmock/gmock.h>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace components_test {

class WithLibrary : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (started()) return;
        started() = true;
        ::setenv("RTT_COMPONENT_PATH", OCL_TEST_PATH, 1);
        static char program[] = "component_library_test", option[] = "--option";
        static char* words[] = {program, option, nullptr};
        ASSERT_EQ(0, __os_init(2, words));
        (void)deployer();
    }
    static OCL::DeploymentComponent& deployer() {
        static OCL::DeploymentComponent* const one = new OCL::DeploymentComponent("Deployer");
        return *one;
    }

private:
    static bool& started() {
        static bool once = false;
        return once;
    }
};

}  // namespace components_test

#endif
