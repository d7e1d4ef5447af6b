// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The source files that describe types: their names, and which type goes into which.
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
    std::size_t header;  ///< number of the listed header whose types it describes
    std::string word;    ///< "tank" of types_tank.cpp; "tank_1" and so on if the header has several
};

/// Returns how many sources a header of this size has by default. The compiler needs 20 MB and a second or two for a
/// type; a type and its comments have some hundred bytes. UseOrocos has the same rule (OrocosTypegen.cmake).
constexpr std::size_t piecesFor(std::uintmax_t bytes) { return static_cast<std::size_t>(bytes / 4096 + 1); }

/// Returns sources in the order of the headers. They depend only on names and numbers of pieces, so CMake can ask
/// early. A word is the header's name without folder and extension, with folders in front where that is not unique.
std::vector<Source> sourcesOf(const std::vector<model::Header>& headers);

/// Finds the source that describes a type: one of its header's. A header's types are dealt out evenly in their order,
/// because a change of the header compiles all its sources again anyway.
class Placement {
public:
    Placement(const model::TypeModel& model, const TypeNeeds& needs);

    const std::vector<Source>& sources() const { return sources_; }
    /// Returns the index in sources() of a type, given its registry name.
    std::size_t of(const std::string& name) const;

private:
    void deal(const std::vector<std::string>& names, const TypeNeeds& needs);

    std::vector<Source> sources_;
    std::map<std::string, std::size_t> places_;
};

}  // namespace oroforge::typekit

#endif
