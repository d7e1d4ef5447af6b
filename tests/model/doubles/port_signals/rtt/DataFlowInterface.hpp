// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: a component that is told of new samples.
#ifndef OROFORGE_MODEL_DATA_FLOW_INTERFACE_HPP
#define OROFORGE_MODEL_DATA_FLOW_INTERFACE_HPP

#include <model/checker/atomic.hpp>

#include <functional>

namespace RTT {
namespace base {
class InputPortInterface;
}

class DataFlowInterface {
public:
    void dataOnPort(base::InputPortInterface* port) {
        told.fetch_add(1, std::memory_order_relaxed);
        (void)alive.get();
        if (onData) onData(port);
    }
    std::atomic<int> told{0};
    model::Plain<int> alive{1};  // read when told: nobody may be destroying the component
    std::function<void(base::InputPortInterface*)> onData;
};

}  // namespace RTT
#endif
