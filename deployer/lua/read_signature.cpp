// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "read_signature.hpp"

#include "failure.hpp"
#include "values.hpp"

#include <rtt/internal/DataSource.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <cctype>
#include <vector>

namespace OCL::lua {

namespace {

typedef RTT::internal::OperationSignature::Value Value;

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\n");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

/** What commas separate, but not those within <>. */
std::vector<std::string> parts(const std::string& text) {
    std::vector<std::string> found(1);
    int depth = 0;
    for (const char letter : text) {
        depth += letter == '<' ? 1 : letter == '>' ? -1 : 0;
        if (letter == ',' && depth == 0)
            found.emplace_back();
        else
            found.back() += letter;
    }
    if (found.size() == 1 && trimmed(found[0]).empty()) found.clear();
    return found;
}

/** Looks the type up; false if there is none. */
bool complete(Value& value) {
    const std::string std = "std::";
    value.type = findType(value.typeName);
    if (!value.type && value.typeName.compare(0, std.size(), std) == 0)
        value.type = findType(value.typeName.substr(std.size()));
    if (!value.type) return false;
    value.id = value.type->getTypeId();
    value.typeName = value.type->getTypeName();
    return true;
}

/** A type, which may be followed by a name. */
Value argument(const std::string& text) {
    Value value = Value::parsed(text);
    if (complete(value)) return value;
    std::size_t end = text.size();
    while (end > 0 && (std::isalnum(static_cast<unsigned char>(text[end - 1])) || text[end - 1] == '_')) --end;
    if (end > 0 && end < text.size()) {
        value = Value::parsed(trimmed(text.substr(0, end)));
        if (complete(value)) {
            value.name = text.substr(end);
            return value;
        }
    }
    throw Failure("no typekit that is loaded has the type of '" + text + "'");
}

}  // namespace

RTT::internal::OperationSignature readSignature(const std::string& text) {
    const auto open = text.find('('), close = text.rfind(')');
    if (open == std::string::npos || close == std::string::npos || close < open ||
        !trimmed(text.substr(close + 1)).empty())
        throw Failure("'" + text + "' is no signature such as 'double(double x, int n)'");
    RTT::internal::OperationSignature read;
    const std::string result = trimmed(text.substr(0, open));
    read.result = result == "void" ? Value::parsed("void") : argument(result);
    if (read.result.isVoid()) read.result.type = RTT::internal::DataSource<void>::GetTypeInfo();
    for (const std::string& part : parts(text.substr(open + 1, close - open - 1))) {
        const std::string one = trimmed(part);
        if (one == "void") continue;
        read.arguments.push_back(argument(one));
        if (read.arguments.back().isPointer) throw Failure("'" + one + "': pointers cannot be passed to Lua");
    }
    return read;
}

}  // namespace OCL::lua
