// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: a component that is told of new samples.
#ifndef OROFORGE_MODEL_DATA_FLOW_INTERFACE_HPP
#define OROFORGE_MODEL_DATA_FLOW_INTERFACE_HPP

#include <model/checker/atomic.hpp>

namespace RTT {
namespace base {
class InputPortInterface;
}

class DataFlowInterface {
public:
    void dataOnPort(base::InputPortInterface*) { told = told + 1; }
    model::Plain<int> told{0};  // one writer only
};

}  // namespace RTT
#endif
