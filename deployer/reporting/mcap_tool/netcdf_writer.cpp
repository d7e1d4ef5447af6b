// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_writer.hpp"

namespace oroforge::mcap {
namespace {

constexpr std::size_t kBlock = std::size_t(1) << 16;

void fillUp(Bytes& out) {
    while (out.size() % 4 != 0) out.push_back(0);
}

void putText(Bytes& out, const std::string& text) {
    putBig(out, std::uint64_t(text.size()));
    out.insert(out.end(), text.begin(), text.end());
    fillUp(out);
}

/** In front of a list: what is in it and how many; zeros if it is empty. */
void putList(Bytes& out, std::uint32_t kind, std::size_t count) {
    putBig(out, count == 0 ? std::uint32_t(0) : kind);
    putBig(out, std::uint64_t(count));
}

constexpr std::uint32_t kDimensions = 10, kVariables = 11, kAttributes = 12;

void putAttributes(Bytes& out, const NetcdfVariable& its) {
    putList(out, kAttributes, its.texts.size() + (its.fill.empty() ? 0 : 1));
    for (const auto& [name, value] : its.texts) {
        putText(out, name);
        putBig(out, static_cast<std::uint32_t>(NetcdfType::Char));
        putText(out, value);
    }
    if (its.fill.empty()) return;
    putText(out, "_FillValue");
    putBig(out, static_cast<std::uint32_t>(its.type));
    putBig(out, std::uint64_t(1));
    out.insert(out.end(), its.fill.begin(), its.fill.end());
    fillUp(out);
}

}  // namespace

std::size_t sizeOf(NetcdfType type) {
    switch (type) {
        case NetcdfType::Byte:
        case NetcdfType::Char:
        case NetcdfType::UByte: return 1;
        case NetcdfType::Short:
        case NetcdfType::UShort: return 2;
        case NetcdfType::Int:
        case NetcdfType::UInt:
        case NetcdfType::Float: return 4;
        default: return 8;
    }
}

std::size_t NetcdfWriter::addDimension(const std::string& name, std::uint64_t length) {
    dimensions_.emplace_back(name, length);
    return dimensions_.size() - 1;
}

std::size_t NetcdfWriter::addVariable(NetcdfVariable variable) {
    variables_.emplace_back();
    Variable& its = variables_.back();
    its.size = sizeOf(variable.type);
    for (const std::size_t dimension : variable.dimensions) its.size *= dimensions_[dimension].second;
    its.its = std::move(variable);
    return variables_.size() - 1;
}

Bytes NetcdfWriter::head() const {
    Bytes out{'C', 'D', 'F', 5};
    putBig(out, std::uint64_t(0));  // records: no dimension is unlimited
    putList(out, kDimensions, dimensions_.size());
    for (const auto& [name, length] : dimensions_) {
        putText(out, name);
        putBig(out, length);
    }
    putList(out, kAttributes, 0);
    putList(out, kVariables, variables_.size());
    for (const Variable& variable : variables_) {
        putText(out, variable.its.name);
        putBig(out, std::uint64_t(variable.its.dimensions.size()));
        for (const std::size_t dimension : variable.its.dimensions) putBig(out, std::uint64_t(dimension));
        putAttributes(out, variable.its);
        putBig(out, static_cast<std::uint32_t>(variable.its.type));
        putBig(out, (variable.size + 3) / 4 * 4);
        putBig(out, variable.begin);
    }
    return out;
}

std::string NetcdfWriter::begin() {
    std::uint64_t at = head().size();
    for (Variable& variable : variables_) {
        variable.begin = at;
        at += (variable.size + 3) / 4 * 4;
    }
    const Bytes out = head();
    std::string error = file_.writeAt(0, out.data(), out.size());
    // The last value may be followed by bytes that fill it up.
    const unsigned char end[4] = {0, 0, 0, 0};
    if (error.empty() && at > out.size()) error = file_.writeAt(at - sizeof end, end, sizeof end);
    return error;
}

std::string NetcdfWriter::append(std::size_t variable, const Bytes& row) {
    Variable& its = variables_[variable];
    its.waiting.insert(its.waiting.end(), row.begin(), row.end());
    return its.waiting.size() < kBlock ? std::string() : flush(its);
}

std::string NetcdfWriter::flush(Variable& variable) {
    const std::string error =
        file_.writeAt(variable.begin + variable.written, variable.waiting.data(), variable.waiting.size());
    variable.written += variable.waiting.size();
    variable.waiting.clear();
    return error;
}

std::string NetcdfWriter::finish() {
    for (Variable& variable : variables_)
        if (const std::string error = flush(variable); !error.empty()) return error;
    return {};
}

}  // namespace oroforge::mcap
