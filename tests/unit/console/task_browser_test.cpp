// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// OCL::TaskBrowser, as programs use it.
#include "console_fixture.hpp"

#include <ocl/TaskBrowser.hpp>

#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace {

class Browser : public ConsoleTest {
protected:
    Browser() : task_browser(plant) {}
    std::string outputOf(const std::string& line) {
        testing::internal::CaptureStdout();
        task_browser.evaluate(line);
        return testing::internal::GetCapturedStdout();
    }

    OCL::TaskBrowser task_browser;
};

TEST_F(Browser, EvaluatesALine) {
    EXPECT_EQ(" = 3\n", outputOf("1 + 2"));
    EXPECT_EQ("pump  [S]\ntank  [U]\n", outputOf("peers"));
    std::string line = "4";
    testing::internal::CaptureStdout();
    task_browser.evalCommand(line);
    EXPECT_EQ(" = 4\n", testing::internal::GetCapturedStdout());
}

TEST_F(Browser, GoesToAnotherComponent) {
    task_browser.switchTaskContext(tank.get());
    EXPECT_EQ(" = \"water\"\n", outputOf("label"));
    outputOf("cd ..");
    EXPECT_EQ("pump  [S]\ntank  [U]\n", outputOf("peers"));
}

TEST_F(Browser, HasColoursIfWanted) {
    task_browser.setColorTheme(OCL::TaskBrowser::whitebg);
    EXPECT_EQ(" = \033[35m3\033[0m\n", outputOf("1 + 2"));
    task_browser.setColorTheme(OCL::TaskBrowser::nocolors);
    EXPECT_EQ(" = 3\n", outputOf("1 + 2"));
}

TEST_F(Browser, NeedsAComponent) {
    EXPECT_THROW(OCL::TaskBrowser(nullptr), std::invalid_argument);
    EXPECT_THROW(task_browser.switchTaskContext(nullptr), std::invalid_argument);
}

TEST_F(Browser, LoopEndsAtTheEndOfTheInputAndWhenItIsToEnd) {
    const int before = dup(STDIN_FILENO);
    int ends[2];
    ASSERT_EQ(0, pipe(ends));
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, STDIN_FILENO);
    task_browser.loop();
    dup2(ends[0], STDIN_FILENO);  // nobody writes
    int wakes[2];
    ASSERT_EQ(0, pipe(wakes));
    task_browser.endOn(wakes[0]);
    ASSERT_EQ(1, write(wakes[1], "x", 1));
    task_browser.loop();
    dup2(before, STDIN_FILENO);
    for (const int descriptor : {before, nothing, ends[0], ends[1], wakes[0], wakes[1]}) close(descriptor);
}

}  // namespace
