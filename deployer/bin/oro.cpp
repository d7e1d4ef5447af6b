// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Looks at and commands running deployments. Does not link the runtime.
#include <live/client/program.hpp>

int main(int argc, char** argv) { return oroforge::live_client::runProgram({argv + 1, argv + argc}); }
