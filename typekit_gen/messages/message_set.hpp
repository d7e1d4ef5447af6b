// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The messages that a package has, and all those that they are made of.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_SET_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_SET_HPP

#include <map>
#include <set>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <messages/message.hpp>
#include <messages/package_search.hpp>

namespace oroforge::messages {

/// Reads a file when its message is first asked for. Errors have the codes RM001 to RM007.
class MessageSet {
public:
    MessageSet(PackageSearch& search, diag::Sink& sink) : search_(search), sink_(sink) {}

    /// Says which file has a message; without this, files are looked up by the names of messages.
    void addFile(const std::string& package, const std::string& file);

    /// Reads a message and all that it is made of; null after errors. `where` names it.
    const Message* message(const std::string& fullName, const diag::Location& where);
    /// The same for a service that a file has.
    const Service* service(const std::string& package, const std::string& file);
    /// Adds a message whose text is known, for tests and for the halves of services.
    const Message* add(Message message);

    /// Returns a message that has been read, or null.
    const Message* find(const std::string& fullName) const;
    /// Returns all files that were read.
    const std::vector<std::string>& files() const { return files_; }

private:
    bool readParts(const Message& message);
    std::string fileOf(const std::string& fullName, const diag::Location& where);
    bool read(const std::string& file, std::string& text, const diag::Location& where);

    PackageSearch& search_;
    diag::Sink& sink_;
    std::map<std::string, std::string> given_;
    std::map<std::string, Message> messages_;
    std::map<std::string, Service> services_;
    std::set<std::string> failed_;
    std::set<std::string> complete_;
    std::vector<const Field*> open_;  ///< the way to what is being read
    std::vector<std::string> openNames_;
    std::vector<std::string> files_;
};

}  // namespace oroforge::messages

#endif
