// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_MESSAGE_DECODER_HPP
#define OROFORGE_REPLAY_MESSAGE_DECODER_HPP

#include "transcoder.hpp"

#include <reporting/mcap/records.hpp>
#include <rtt/encoding/Plan.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <memory>
#include <string>
#include <vector>

namespace OCL::replay {

/** A problem with a channel, without the file and the topic. */
struct Refusal {
    const char* code = nullptr;
    std::string text;
};

/** Turns the messages of a channel into values of a loaded type. */
class MessageDecoder {
public:
    /** Compares the type with the recorded one. Null, with the reason, if they differ, or with `tolerate` if they have
        nothing in common. With `tolerate`, a decoder may come with a text about what differs. */
    static std::unique_ptr<MessageDecoder> make(const RTT::types::TypeInfo& type,
                                                const oroforge::mcap::Channel& channel,
                                                const oroforge::mcap::Schema* schema, bool tolerate, Refusal& refusal);

    /** Sets the value. Empty if all went well; otherwise what is wrong, and the value is some valid one. Allocates as
        Plan::decode does if the types are the same, and otherwise always. */
    std::string decode(const oroforge::mcap::Message& message, void* value);

private:
    explicit MessageDecoder(std::shared_ptr<const RTT::encoding::Plan> plan) : plan_(std::move(plan)) {}
    bool compare(const RTT::types::TypeInfo& type, const oroforge::mcap::Schema& schema, bool tolerate,
                 Refusal& refusal);

    const std::shared_ptr<const RTT::encoding::Plan> plan_;
    std::unique_ptr<const Transcoder> transcoder_;  // null if the types are the same
    std::vector<unsigned char> bytes_;
};

}  // namespace OCL::replay

#endif
