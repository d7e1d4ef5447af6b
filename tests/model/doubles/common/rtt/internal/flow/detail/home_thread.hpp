// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: the scenario says which thread is at home.
#ifndef OROFORGE_MODEL_HOME_THREAD_HPP
#define OROFORGE_MODEL_HOME_THREAD_HPP

#include <model/checker/checker.hpp>

namespace model {

/** The number of the thread; 0, the one that sets up, is none. */
inline unsigned homeThread = 0;

/** The scenario with that thread at home. */
template <unsigned number, void (*scenario)(Trial&)>
void atHome(Trial& trial) {
    homeThread = number;
    scenario(trial);
}
/** With none. */
template <void (*scenario)(Trial&)>
void away(Trial& trial) {
    atHome<0, scenario>(trial);
}

}  // namespace model

namespace RTT {
namespace internal {
namespace detail {

class HomeThread {
public:
    bool here() const { return model::homeThread != 0 && model::self() == model::homeThread; }
    void wrote() {}
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
