// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"
#include "json_line.hpp"
#include "leaves.hpp"
#include "opened_file.hpp"

#include <iostream>

namespace oroforge::mcap {

int cat(const ToolOptions& options) {
    const std::unique_ptr<OpenedFile> file = OpenedFile::open(options.files[0]);
    if (!file) return kFailed;
    for (const std::string& topic : options.topics)
        if (!isTopicOf(*file, topic)) return kFailed;
    Decoders decoders(file->name());
    file->read({options.topics.begin(), options.topics.end()}, [&](const Channel& channel, const Message& message) {
        JsonLine value;
        if (!decoders.walk(channel, file->schemaOf(channel), message, value)) return;
        JsonLine topic;
        topic.text(channel.topic);
        std::cout << "{\"topic\": " << topic.line << ", \"time\": " << secondsOf(message.logTime)
                  << ", \"sequence\": " << message.sequence << ", \"message\": " << value.line << "}\n";
    });
    return file->isDamaged() || decoders.failed() ? kDamaged : kGood;
}

}  // namespace oroforge::mcap
