// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/identity.hpp>

#include <algorithm>
#include <vector>

#include <messages/md5.hpp>

namespace oroforge::messages {

namespace {

/// Constants first, then fields; messages are replaced by their sums.
std::string summedText(const Message& message, const MessageSet& set) {
    std::string text;
    for (const Constant& one : message.constants) text += one.type + " " + one.name + "=" + one.value + "\n";
    for (const Field& field : message.fields)
        text +=
            (field.type.isBuiltin ? field.written : md5Of(*set.find(field.type.name), set)) + " " + field.name + "\n";
    if (!text.empty()) text.pop_back();
    return text;
}

/// Depth first, a message before its own parts.
void collectParts(const Message& message, const MessageSet& set, std::vector<std::string>& names) {
    for (const Field& field : message.fields) {
        if (field.type.isBuiltin) continue;
        const bool isNew = std::find(names.begin(), names.end(), field.type.name) == names.end();
        if (isNew) names.push_back(field.type.name);
        if (isNew) collectParts(*set.find(field.type.name), set, names);
    }
}

}  // namespace

std::string md5Of(const Message& message, const MessageSet& set) { return md5(summedText(message, set)); }

std::string md5Of(const Service& service, const MessageSet& set) {
    return md5(summedText(service.request, set) + summedText(service.response, set));
}

std::string definitionOf(const Message& message, const MessageSet& set) {
    std::vector<std::string> names;
    collectParts(message, set, names);
    std::string text = message.text + "\n";
    for (const std::string& name : names)
        text += std::string(80, '=') + "\nMSG: " + name + "\n" + set.find(name)->text + "\n";
    text.pop_back();
    return text;
}

}  // namespace oroforge::messages
