// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The source files that describe types: what they are called, and which type goes into which.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_SOURCES_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_SOURCES_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <model/type_model.hpp>

namespace oroforge::typekit {

class TypeNeeds;

struct Source {
    std::size_t header;  ///< the number of the listed one whose types it describes
    std::string word;    ///< "tank" of types_tank.cpp; "tank_1" and so on where a header has several
};

/// How many sources a header of this size has, if nobody says otherwise. The compiler needs 20 MB for a type and a second
/// or two; a type and its comments are some hundred bytes. UseOrocos has the same rule (OrocosTypegen.cmake).
constexpr std::size_t piecesFor(std::uintmax_t bytes) { return static_cast<std::size_t>(bytes / 4096 + 1); }

/// In the order of the headers. A function of their names and numbers of pieces, so that CMake can ask before anything
/// is read. A word is the header's name without folder and extension; where that is not enough, folders come in front.
std::vector<Source> sourcesOf(const std::vector<model::Header>& headers);

/// Where each type is described: in a source of the header that it belongs to. A header's types are dealt out evenly in
/// their order; all its sources are compiled again anyway when it changes.
class Placement {
public:
    Placement(const model::TypeModel& model, const TypeNeeds& needs);

    const std::vector<Source>& sources() const { return sources_; }
    /// A number in sources(), of a type by its name in the registry.
    std::size_t of(const std::string& name) const;

private:
    void deal(const std::vector<std::string>& names, const TypeNeeds& needs);

    std::vector<Source> sources_;
    std::map<std::string, std::size_t> places_;
};

}  // namespace oroforge::typekit

#endif
