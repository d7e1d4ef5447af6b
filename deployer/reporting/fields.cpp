// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "fields.hpp"

namespace OCL::reporting {
namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == text.npos ? std::string() : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

void describe(Field& field, const std::string& text) {
    field.description = trimmed(text);
    const std::size_t end = text.rfind(']');
    const std::size_t begin = end == text.npos ? text.npos : text.rfind('[', end);
    if (begin == text.npos) return;
    field.unit = trimmed(text.substr(begin + 1, end - begin - 1));
    const std::string rest = trimmed(text.substr(end + 1));
    field.description = trimmed(text.substr(0, begin));
    if (!rest.empty()) field.description += (field.description.empty() ? "" : " ") + rest;
}

}  // namespace OCL::reporting
