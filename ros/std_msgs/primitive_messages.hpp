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

/** Numbers, bool, texts and times, whose bytes are those of std_msgs/Bool and so on, and vectors of numbers, which are
    …MultiArray. */
MessageTable primitiveMessages();

}  // namespace std_msgs

#endif
