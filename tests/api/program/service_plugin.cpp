// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The file of a service plugin. Here its symbols are those of the program.
#include <rtt/plugin/ServicePlugin.hpp>

namespace velma {

class RTT_EXPORT Counter : public RTT::Service {
    int count;

public:
    typedef boost::shared_ptr<Counter> shared_ptr;
    Counter(RTT::TaskContext* owner) : RTT::Service("counter", owner), count(0) {
        this->addOperation("next", &Counter::next, this).doc("The next number.");
    }
    int next() { return ++count; }
};

}  // namespace velma

ORO_SERVICE_NAMED_PLUGIN(velma::Counter, "counter")

int check_service_plugin() {
    RTT::TaskContext task("task");
    if (getRTTPluginName() != "counter" || getRTTTargetName() != OROCOS_TARGET_NAME) return 1;
    if (!loadRTTPlugin(0)) return 2;
    if (!loadRTTPlugin(&task) || !task.provides()->hasService("counter")) return 3;
    RTT::OperationCaller<int(void)> next = task.provides("counter")->getOperation("next");
    if (next() != 1 || next() != 2) return 4;
    velma::Counter::shared_ptr same = task.getProvider<velma::Counter>("counter");
    if (!same || same->next() != 3) return 5;
    RTT::Service::shared_ptr loose = createService();
    return loose && !loose->getOwner() ? 0 : 6;
}
