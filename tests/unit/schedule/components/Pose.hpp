// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A type that is another one in the second package.
#ifndef OROFORGE_TESTS_SCHEDULE_POSE_HPP
#define OROFORGE_TESTS_SCHEDULE_POSE_HPP

namespace replaytest {

struct Pose {
    double x = 0;
#ifdef REPLAYTEST_CHANGED
    int quality = 7;
#endif
};

}  // namespace replaytest

#endif
