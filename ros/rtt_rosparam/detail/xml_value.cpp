// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "xml_value.hpp"

#include <sstream>

namespace rtt_rosparam {

std::string described(const XmlRpc::XmlRpcValue& value) {
    typedef XmlRpc::XmlRpcValue Value;
    constexpr std::size_t kMost = 40;
    std::ostringstream text;
    switch (value.getType()) {
        case Value::TypeBoolean: text << "a bool (" << (as<bool>(value) ? "true" : "false") << ')'; break;
        case Value::TypeInt: text << "an int (" << as<int>(value) << ')'; break;
        case Value::TypeDouble: text << "a double (" << as<double>(value) << ')'; break;
        case Value::TypeString: {
            const auto& letters = as<std::string>(value);
            text << "a string ('" << letters.substr(0, kMost) << (letters.size() > kMost ? "…')" : "')");
            break;
        }
        case Value::TypeDateTime: text << "a date"; break;
        case Value::TypeBase64: text << "binary data"; break;
        case Value::TypeArray: text << "an array of " << value.size() << " elements"; break;
        case Value::TypeStruct: text << "a struct"; break;
        case Value::TypeInvalid: text << "nothing"; break;
    }
    return text.str();
}

}  // namespace rtt_rosparam
