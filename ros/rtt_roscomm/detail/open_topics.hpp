// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_OPEN_TOPICS_HPP
#define RTT_ROSCOMM_DETAIL_OPEN_TOPICS_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace rtt_roscomm::detail {

/** What is known of one end of a topic. */
struct TopicState {
    std::string topic, message, described;
    std::uint64_t samples = 0;  ///< published or received
    std::uint64_t lost = 0;     ///< for which a buffer had no room, or messages that were no samples
    unsigned peers = 0;
};

/** An end of a topic that is open, for what looks at it from outside. While there is one, the master is watched. */
class OpenTopic {
public:
    OpenTopic(const OpenTopic&) = delete;
    OpenTopic& operator=(const OpenTopic&) = delete;
    virtual TopicState state() const = 0;

protected:
    OpenTopic() = default;
    ~OpenTopic() = default;
    /** From the end of this call to the beginning of the other one, state() may be called by any thread. */
    void show();
    void hide();
};

/** By topic. */
std::vector<TopicState> openTopics();

}  // namespace rtt_roscomm::detail

#endif
