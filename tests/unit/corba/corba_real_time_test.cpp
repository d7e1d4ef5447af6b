// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a connection with another process asks of the thread that writes.
#include <support/real_time_trap.hpp>

#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>

#include "peer_fixture.hpp"

#include <string>

using namespace RTT;
using oroforge::test::RealTimeTrap;

namespace {

class CorbaRealTime : public corba_test::PeerFixture {};

}  // namespace

TEST_F(CorbaRealTime, AWriterTakesNoMemoryNoLockAndWaitsForNothing) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    TaskContext here("here");
    OutputPort<double> out("out");
    here.addPort(out);
    for (const int type : {ConnPolicy::DATA, ConnPolicy::BUFFER, ConnPolicy::CIRCULAR_BUFFER})
        for (const bool pull : {ConnPolicy::PUSH, ConnPolicy::PULL}) {
            SCOPED_TRACE(std::to_string(type) + (pull ? " pull" : " push"));
            ConnPolicy policy = type == ConnPolicy::DATA ? ConnPolicy::data() : ConnPolicy::buffer(10);
            policy.type = type;
            policy.pull = pull;
            ASSERT_TRUE(out.connectTo(peer->getPort("in"), policy));
            {
                const RealTimeTrap trap;
                for (int i = 0; i != 1000; ++i) (void)out.write(i);
            }
            out.disconnect();
        }
}
