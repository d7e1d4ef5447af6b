// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro record, without a library that compresses recordings
#include "failure.hpp"
#include "session.hpp"

namespace oroforge::live_client {

void recordPorts(Session&) {
    throw Failure(Status::Refused,
                  "this oro was built without recordings; install libzstd-dev or liblz4-dev and build it anew");
}

}  // namespace oroforge::live_client
