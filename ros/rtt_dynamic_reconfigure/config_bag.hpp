// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of configurations of dynamic_reconfigure in bags of properties, by their names.
#ifndef RTT_DYNAMIC_RECONFIGURE_CONFIG_BAG_HPP
#define RTT_DYNAMIC_RECONFIGURE_CONFIG_BAG_HPP

#include <dynamic_reconfigure/Config.h>
#include <rtt/PropertyBag.hpp>

namespace rtt_dynamic_reconfigure {

/** Sets the properties of the names in `config`, `a__b` for property b of bag a, and adds those that are missing, as
    bool, int, double and string. False if one has a type that does not fit, or cannot hold the value; the others are set
    nevertheless. */
bool bagFromConfig(const dynamic_reconfigure::Config& config, RTT::PropertyBag& bag);

/** Sets all values in `config` from properties of their names. False if one is missing or does not fit; its value stays. */
bool configFromBag(const RTT::PropertyBag& bag, dynamic_reconfigure::Config& config);

}  // namespace rtt_dynamic_reconfigure

#endif
