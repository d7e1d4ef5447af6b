// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/type_names.hpp>

#include <rtt/types/TypeInfo.hpp>

#include <boost/core/demangle.hpp>

#include <cctype>
#include <cstdint>
#include <cstring>
#include <typeinfo>
#include <utility>
#include <vector>

namespace RTT::corba::detail {

namespace {

std::string onlyLetters(std::string text) {
    for (char& letter : text)
        if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
    return text;
}

/** The parts of "/a/b/T<c/d>": a, b, T<c/d>. */
std::vector<std::string> partsOf(const std::string& name) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char letter : name) {
        depth += letter == '<' ? 1 : letter == '>' ? -1 : 0;
        if (letter != '/' || depth != 0)
            parts.back() += letter;
        else if (!parts.back().empty())
            parts.emplace_back();
    }
    return parts;
}

/** With a number of bits, as the original names them, for numbers; otherwise the name of the type. */
std::string fullName(const types::TypeInfo& type) {
    static const std::vector<std::pair<const char*, const char*>> numbers = {
        {typeid(char).name(), "/int8_t"},
        {typeid(signed char).name(), "/int8_t"},
        {typeid(unsigned char).name(), "/uint8_t"},
        {typeid(std::int16_t).name(), "/int16_t"},
        {typeid(std::uint16_t).name(), "/uint16_t"},
        {typeid(int).name(), "/int32_t"},
        {typeid(unsigned).name(), "/uint32_t"},
        {typeid(long).name(), "/int64_t"},
        {typeid(unsigned long).name(), "/uint64_t"},
        {typeid(long long).name(), "/int64_t"},
        {typeid(unsigned long long).name(), "/uint64_t"},
        {typeid(std::string).name(), "/std/string"}};
    for (const auto& [id, name] : numbers)
        if (std::strcmp(id, type.getTypeIdName()) == 0) return name;
    const std::string& name = type.getTypeName();
    return name.empty() || name[0] == '/' ? name : "/" + name;
}

/** "IDL:orogen/a/b/Corba/" for "/a/b/T"; the standard library has no module. */
std::string moduleOf(const std::string& name) {
    const std::vector<std::string> parts = partsOf(name);
    std::string module = "IDL:orogen/";
    if (parts.front() != "std")
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) module += idlMember(parts[i]) + '/';
    return module + "Corba/";
}

/** "vector" for std::vector<…>. */
std::string kindOf(const types::TypeInfo& container) {
    const std::string name = boost::core::demangle(container.getTypeIdName());
    const std::string plain = name.substr(0, name.find('<'));
    const std::size_t colon = plain.rfind(':');
    return onlyLetters(colon == std::string::npos ? plain : plain.substr(colon + 1));
}

}  // namespace

std::string idlMember(const std::string& name) {
    const std::string plain = onlyLetters(name[0] == '_' ? name.substr(1) : name);
    return std::isalpha(static_cast<unsigned char>(plain[0])) ? plain : "m" + plain;
}

IdlName idlNameOf(const types::TypeInfo& type) {
    const std::string full = fullName(type);
    const std::string name = idlMember(partsOf(full).back());
    return {moduleOf(full) + name + ":1.0", name};
}

IdlName idlNameOfContainer(const types::TypeInfo& container, const types::TypeInfo& element) {
    const std::string full = fullName(element);
    const std::string name = kindOf(container) + '_' + onlyLetters(full) + '_';
    return {moduleOf(full) + name + ":1.0", name};
}

}  // namespace RTT::corba::detail
