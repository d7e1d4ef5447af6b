// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DYNAMIC_RECONFIGURE_DETAIL_MERGE_HPP
#define RTT_DYNAMIC_RECONFIGURE_DETAIL_MERGE_HPP

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <cstdint>
#include <string>

namespace rtt_dynamic_reconfigure::detail {

/** What a request makes of the present values: numbers are limited to min and max of the description, and `level` has the
    levels of those that differ then. A value that the request does not change is not limited. False, with the reason, if
    the request has a value that is no number, or of another type. */
bool merge(const dynamic_reconfigure::ConfigDescription& description, const dynamic_reconfigure::Config& present,
           const dynamic_reconfigure::Config& request, dynamic_reconfigure::Config& merged, std::uint32_t& level,
           std::string& why);

}  // namespace rtt_dynamic_reconfigure::detail

#endif
