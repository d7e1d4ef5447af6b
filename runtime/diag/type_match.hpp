// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// "Did you mean …?" for names with namespaces.
#ifndef OROFORGE_DIAG_TYPE_MATCH_HPP
#define OROFORGE_DIAG_TYPE_MATCH_HPP

#include <diag/nearest_match.hpp>

#include <string>
#include <vector>

namespace oroforge::diag {

/// True if `inner` is `name` in a namespace.
inline bool isInNamespace(const std::string& inner, const std::string& name) {
    const std::string end = "::" + name;
    return inner.size() > end.size() && inner.compare(inner.size() - end.size(), end.size(), end) == 0;
}

/// As didYouMean(), but prefers a candidate that is the name in a namespace, or the name without its namespace.
inline std::string didYouMeanType(const std::string& name, const std::vector<std::string>& candidates) {
    for (const std::string& candidate : candidates)
        if (isInNamespace(candidate, name) || isInNamespace(name, candidate))
            return "; did you mean '" + candidate + "'?";
    return didYouMean(name, candidates);
}

}  // namespace oroforge::diag

#endif
