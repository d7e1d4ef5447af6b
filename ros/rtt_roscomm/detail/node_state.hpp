// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_NODE_STATE_HPP
#define RTT_ROSCOMM_DETAIL_NODE_STATE_HPP

#include <rtt_roscomm/node_state.hpp>

#endif
