// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/access_view.hpp>

namespace oroforge::typekit {

nlohmann::json accessView(const model::FieldAccess& access) {
    nlohmann::json view = {{model::word(access.kind), true}, {"get", access.get}};
    if (!access.set.empty()) view["set"] = access.set;
    if (access.number != 0) view["number"] = access.number;
    if (!access.pointee.empty()) view["pointee"] = access.pointee;
    if (access.isAssigned) view["assigned"] = true;
    if (access.hasAddress) view["address"] = true;
    return view;
}

}  // namespace oroforge::typekit
