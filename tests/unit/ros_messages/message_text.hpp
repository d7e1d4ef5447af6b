// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_MESSAGES_MESSAGE_TEXT_HPP
#define OROFORGE_TESTS_ROS_MESSAGES_MESSAGE_TEXT_HPP

#include <string>

#include <diag/sink.hpp>
#include <messages/message_set.hpp>
#include <messages/parse_message.hpp>

#include "support/temp_dir.hpp"

namespace oroforge::test {

/// Packages in a folder of their own, read as typegen-ros does.
struct MessageFolder {
    TempDir dir;
    diag::Sink sink;
    messages::PackageSearch search;
    messages::MessageSet set{search, sink};

    void write(const std::string& fullName, const std::string& text) {
        const std::string package = fullName.substr(0, fullName.find('/'));
        dir.write(package + "/msg/" + fullName.substr(fullName.find('/') + 1) + ".msg", text);
        search.add(package, (dir / (package + "/msg")).string());
    }
    const messages::Message* read(const std::string& fullName) { return set.message(fullName, {"test"}); }
    std::string firstError() const { return sink.all().empty() ? "" : textOf(sink.all()[0]); }

    static std::string textOf(const diag::Diagnostic& one) {
        const std::string file = one.where.file.str();
        return file.substr(file.rfind('/') + 1) + ":" + std::to_string(one.where.line) + ":" +
               std::to_string(one.where.column) + ": [" + one.code + "] " + one.message;
    }
};

}  // namespace oroforge::test

#endif
