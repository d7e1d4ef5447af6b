// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef STD_MSGS_PRIMITIVE_MESSAGES_HPP
#define STD_MSGS_PRIMITIVE_MESSAGES_HPP

#include <rtt_roscomm/message_table.hpp>

namespace std_msgs {

struct MessageTable {
    const rtt_roscomm::MessageEntry* first;
    std::size_t count;
};

/** Numbers, bool, string and times: their bytes are those of the message std_msgs/Bool and so on. */
MessageTable plainMessages();

/** Types that are not encoded as their messages: vectors of numbers travel as …MultiArray, which has a layout in front of
    the elements; rt_string is a string. */
MessageTable adaptedMessages();

}  // namespace std_msgs

#endif
