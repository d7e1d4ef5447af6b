// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <console/terminal_signals.hpp>
#include <gtest/gtest.h>

namespace {

using OCL::console::TerminalSignals;

TEST(TerminalSignals, ASizeThatWasAskedForBeforeIsAskedForAgain) {
    raise(SIGWINCH);  // lost: whoever has asked for the size before knows an old one
    TerminalSignals signals(-1);
    EXPECT_TRUE(signals.any());
    EXPECT_TRUE(signals.takeResized());
    EXPECT_FALSE(signals.takeResized());
    EXPECT_FALSE(signals.any());
    raise(SIGWINCH);
    EXPECT_TRUE(signals.takeResized());
    EXPECT_FALSE(signals.takeResumed());
}

}  // namespace
