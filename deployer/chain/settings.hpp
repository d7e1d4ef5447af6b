// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The properties of a chain as they are when it starts.
#ifndef OROFORGE_CHAIN_SETTINGS_HPP
#define OROFORGE_CHAIN_SETTINGS_HPP

#include <rtt/PropertyBag.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace OCL::chain {

enum class OnError { Skip, StopCycle, Stop };

/** Every `every`-th cycle, in those whose number has the remainder `phase`. */
struct Divider {
    unsigned every = 1, phase = 0;
};

/** The values of properties. */
struct Properties {
    std::string on_error = "skip";
    RTT::PropertyBag divider;
    std::vector<std::string> dividers;
    double budget = 0;
    RTT::PropertyBag budgets;
    bool stop_on_overrun = false;
    std::string events = "in_order";
    std::vector<std::string> triggers;
    int report_every = 100;
    bool manage = false;
};

struct Settings {
    OnError onError = OnError::Skip;
    std::map<std::string, Divider> dividers;
    std::int64_t budget = 0;  // ns; 0 for none
    std::map<std::string, std::int64_t> budgets;
    bool stopOnOverrun = false;
    bool inOrder = true;
    unsigned reportEvery = 0;  // 0 for never

    /** Appends what is wrong to `findings`. */
    static Settings from(const Properties& properties, std::vector<std::string>& findings);
};

}  // namespace OCL::chain

#endif
